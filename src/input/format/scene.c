/* SPDX-License-Identifier: MIT
 *
 * Solid models of structured formats: tap-assimp reads them where it was built. STEP is recognised to be refused with advice.
 */
#include "input/format/scene.h"

#include "input/format/model.h"
#include "input/tap.h"

#include <string.h>

/* Where a sign is looked for: at the very start, or within so many bytes. */
#define START 1
#define HEAD 4096
#define JSON ((size_t)1 << 20)

typedef struct {
    const char *format, *name; /* as the tap and as a person calls it */
    const char *begins;        /* what the file starts with, or NULL */
    const char *holds;         /* what stands in its first bytes, or NULL */
    size_t within;
} scene_sign;

static const scene_sign signs[] = {
    {"glb", "glTF", "glTF", NULL, START},
    {"gltf", "glTF", "{", "\"accessors\"", JSON},
    {"gltf", "glTF", "{", "\"asset\"", JSON},
    {"dae", "COLLADA", NULL, "<COLLADA", HEAD},
    {"x3d", "X3D", NULL, "<X3D", HEAD},
    {"amf", "AMF", NULL, "<amf", HEAD},
    {"ifc", "IFC", "ISO-10303-21;", "'IFC", HEAD},
    {NULL, "STEP", "ISO-10303-21;", NULL, START},
    {"fbx", "FBX", "Kaydara FBX Binary", NULL, START},
    {"fbx", "FBX", "; FBX ", NULL, START},
    {"ac", "AC3D", "AC3D", NULL, START},
    {"lwo", "LightWave", "FORM", "LWO2", 12},
    {"lwo", "LightWave", "FORM", "LWOB", 12},
};

static bool contains(const char *data, size_t size, const char *word)
{
    size_t n = strlen(word);
    for (size_t i = 0; i + n <= size; i++)
        if (data[i] == *word && !memcmp(data + i, word, n))
            return true;
    return false;
}

/* A 3DS file is one chunk: its number, then its size, which is the file's. */
static bool is_3ds(const char *data, size_t size)
{
    const unsigned char *at = (const unsigned char *)data;
    return size > 6 && at[0] == 0x4d && at[1] == 0x4d && (at[2] | (size_t)at[3] << 8 | (size_t)at[4] << 16 | (size_t)at[5] << 24) == size;
}

static bool has_sign(const scene_sign *s, const char *data, size_t size)
{
    size_t n = s->begins ? strlen(s->begins) : 0, skipped = 0;
    while (s->begins && *s->begins == '{' && skipped < size && strchr(" \t\r\n", data[skipped]) && data[skipped])
        skipped++;
    if (size - skipped < n || (n && memcmp(data + skipped, s->begins, n)))
        return false;
    return !s->holds || contains(data, size < s->within ? size : s->within, s->holds);
}

static const scene_sign *sign_of(const char *data, size_t size)
{
    static const scene_sign three_ds = {"3ds", "3DS", NULL, NULL, START};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (has_sign(&signs[i], data, size))
            return &signs[i];
    return is_3ds(data, size) ? &three_ds : NULL;
}

bool plb_is_scene(const char *data, size_t size) { return sign_of(data, size) != NULL; }

bool plb_read_scene(const input_source *in, display_list *list, error *err)
{
    char program[PROCESS_PATH_MAX];
    error missing = {ERROR_NONE, ""};
    const scene_sign *s = sign_of(in->data, in->size);
    if (!s->format)
        return plb_fail(err, ERROR_UNSUPPORTED, "%s: this is %s: save it as STL or OBJ (FreeCAD does)", in->name, s->name);
    if (!plb_process_find(in->helper_dir, "tap-assimp", program, &missing))
        return plb_fail(err, ERROR_HELPER, "%s: reading %s needs tap-assimp, which is built where the library assimp is (Debian: libassimp-dev)", in->name, s->name);
    return plb_model_run_tap(in, "tap-assimp", s->format, list, err);
}
