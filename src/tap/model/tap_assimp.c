/* SPDX-License-Identifier: MIT
 *
 * tap-assimp: a solid model of a structured format, read by the library assimp, becomes a display list. It differs from tap-model in nothing
 * else. Files that a model names (buffers, pictures) are not there for it.
 *
 *     tap-assimp gltf|glb|dae|3ds|ifc|fbx|x3d|amf|ac|lwo [--view=AZ,EL] ... <model >list
 */
#include "tap/model/program.h"

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <string.h>

enum { GLTF, GLB, DAE, THREE_DS, IFC, FBX, X3D, AMF, AC, LWO, FORMATS };

/* A node of the scene that waits for its turn, and where it lies. */
typedef struct {
    const struct aiNode *node;
    struct aiMatrix4x4 at;
} waiting;

typedef struct {
    const struct aiScene *scene;
    raw_model *m;
    bool is_linear; /* colours are amounts of light, as in glTF, not what a screen is told */
} scene_reader;

static vector transform(const struct aiMatrix4x4 *t, struct aiVector3D v)
{
    double x = (double)v.x, y = (double)v.y, z = (double)v.z;
    return (vector){(double)t->a1 * x + (double)t->a2 * y + (double)t->a3 * z + (double)t->a4,
                    (double)t->b1 * x + (double)t->b2 * y + (double)t->b3 * z + (double)t->b4,
                    (double)t->c1 * x + (double)t->c2 * y + (double)t->c3 * z + (double)t->c4};
}

/* Gives what a screen would be told of an amount of light: about the root of it (IEC 61966-2-1). */
static float encoded(const scene_reader *r, float part)
{
    float p = part > 0 ? part < 1 ? part : 1 : 0;
    return r->is_linear ? powf(p, 1 / 2.2f) : p;
}

/* The paints are white and the scene's materials, in this order. */
static bool add_materials(scene_reader *r)
{
    bool ok = array_push(&r->m->paints, ((surface_paint){{1, 1, 1}, 0}));
    for (unsigned i = 0; ok && i < r->scene->mNumMaterials; i++) {
        const struct aiMaterial *from = r->scene->mMaterials[i];
        struct aiColor4D c = {1, 1, 1, 1};
        if (aiGetMaterialColor(from, AI_MATKEY_BASE_COLOR, &c) != aiReturn_SUCCESS && aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &c) != aiReturn_SUCCESS)
            c = (struct aiColor4D){1, 1, 1, 1};
        r->m->pictures += aiGetMaterialTextureCount(from, aiTextureType_DIFFUSE) > 0 || aiGetMaterialTextureCount(from, aiTextureType_BASE_COLOR) > 0;
        surface_paint p = {{encoded(r, c.r), encoded(r, c.g), encoded(r, c.b)}, i + 1};
        ok = array_push(&r->m->paints, p);
    }
    return ok;
}

static bool add_mesh(scene_reader *r, const struct aiMesh *from, const struct aiMatrix4x4 *at)
{
    raw_model *m = r->m;
    uint32_t first = (uint32_t)m->places.n, made_of = from->mMaterialIndex < r->scene->mNumMaterials ? from->mMaterialIndex + 1 : 0;
    number_list corners = {0};
    bool ok = array_reserve(&m->places, from->mNumVertices);
    for (unsigned i = 0; ok && i < from->mNumVertices; i++)
        m->places.v[m->places.n++] = transform(at, from->mVertices[i]);
    for (unsigned i = 0; ok && i < from->mNumFaces; i++) {
        const struct aiFace *f = &from->mFaces[i];
        corners.n = 0;
        for (unsigned k = 0; ok && k < f->mNumIndices; k++)
            ok = f->mIndices[k] < from->mNumVertices && array_push(&corners, first + f->mIndices[k]);
        m->points += f->mNumIndices == 1;
        if (ok && f->mNumIndices == 2)
            ok = array_push(&m->wires, corners.v[0]) && array_push(&m->wires, corners.v[1]);
        else if (ok && f->mNumIndices > 2)
            ok = plb_raw_model_add_face(m, corners.v, corners.n, made_of);
    }
    array_free(&corners);
    return ok;
}

/* Walks through the tree of nodes, each of which places some meshes. */
static bool add_nodes(scene_reader *r)
{
    ARRAY(waiting) todo = {0};
    waiting root = {.node = r->scene->mRootNode};
    aiIdentityMatrix4(&root.at);
    bool ok = !root.node || array_push(&todo, root);
    while (ok && todo.n) {
        waiting w = todo.v[--todo.n];
        aiMultiplyMatrix4(&w.at, &w.node->mTransformation);
        for (unsigned i = 0; ok && i < w.node->mNumMeshes; i++)
            ok = w.node->mMeshes[i] >= r->scene->mNumMeshes || add_mesh(r, r->scene->mMeshes[w.node->mMeshes[i]], &w.at);
        for (unsigned i = w.node->mNumChildren; ok && i-- > 0;)
            ok = array_push(&todo, ((waiting){w.node->mChildren[i], w.at}));
    }
    array_free(&todo);
    return ok;
}

static const char *const formats[FORMATS] = {"gltf", "glb", "dae", "3ds", "ifc", "fbx", "x3d", "amf", "ac", "lwo"};

/* Passes on what the library says, but for the name that it makes up for what has none. */
static bool explain(const char *why, error *err)
{
    if (why && strstr(why, "bad_alloc"))
        return plb_fail_memory(err);
    return plb_fail(err, ERROR_SYNTAX, "assimp: %.300s", why && *why && !strstr(why, "$$$") ? why : "it cannot read this");
}

static bool read_scene(const char *data, size_t size, int format, raw_model *m, error *err)
{
    const struct aiScene *scene = aiImportFileFromMemory(data, (unsigned)size, aiProcess_ValidateDataStructure, formats[format]);
    if (!scene)
        return explain(aiGetErrorString(), err);
    scene_reader r = {scene, m, format == GLTF || format == GLB};
    m->up = UP_Y; /* so assimp gives every scene */
    m->unit = format == GLTF || format == GLB || format == DAE || format == IFC ? 1000 : 0; /* metres */
    return (add_materials(&r) && add_nodes(&r)) || plb_fail_memory(err);
}

int main(int argc, char **argv)
{
    plb_model_program(argc, argv, formats, FORMATS, read_scene);
}
