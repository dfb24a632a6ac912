/* SPDX-License-Identifier: MIT
 *
 * tap-model from inside: ears, welding, edges, and visibility against rays that look at every triangle.
 */
#include "check.h"

#include "base/number/random.h"
#include "tap/model/hidden/covered.h"
#include "tap/model/view_items.h"

#define MOST ((size_t)4 << 20)

/* ---- models ---- */

static size_t load(const char *name, char *out)
{
    const char *root = getenv("ROOT");
    char file[600];
    snprintf(file, sizeof file, "%s/%s", root ? root : ".", name);
    FILE *f = fopen(file, "rb");
    size_t n = f ? fread(out, 1, MOST, f) : 0;
    if (f)
        fclose(f);
    return n;
}

/* Reads an OBJ and makes its mesh. */
static bool mesh_of(const char *obj, size_t size, mesh *m)
{
    raw_model raw = {0};
    error err = {ERROR_NONE, ""};
    *m = (mesh){0};
    bool ok = plb_model_read(obj, size, MODEL_OBJ, &raw, &err) && plb_mesh_make(&raw, UP_Y, m, &err) && plb_mesh_weld(m, &err) && plb_mesh_edges(m, &err) &&
              plb_mesh_classify(m, 30 * PLB_PI / 180, &err) && plb_mesh_smooth(m, &err);
    if (!ok)
        printf("# %s\n", err.text);
    plb_raw_model_free(&raw);
    return ok;
}

static bool mesh_of_text(const char *obj, mesh *m) { return mesh_of(obj, strlen(obj), m); }

static size_t count_edges(const mesh *m, edge_kind kind)
{
    size_t n = 0;
    for (size_t i = 0; i < m->edges.n; i++)
        n += m->edges.v[i].kind == kind;
    return n;
}

/* ---- polygons ---- */

static double area_of(const vector *v, const number_list *t)
{
    double area = 0;
    for (size_t i = 0; i + 2 < t->n; i += 3)
        area += vector_length(vector_cross(vector_sub(v[t->v[i + 1]], v[t->v[i]]), vector_sub(v[t->v[i + 2]], v[t->v[i]]))) / 2;
    return area;
}

static void ears_fill_a_polygon_and_not_its_dents(void)
{
    static const vector u[] = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {4, 5, 0}, {4, 1, 0}, {1, 1, 0}, {1, 5, 0}, {0, 5, 0}};
    static const vector ring[] = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
    static const vector upright[] = {{0, 0, 0}, {0, 0, 2}, {0, 2, 2}, {0, .5, 1}};
    number_list t = {0};
    error err = {ERROR_NONE, ""};
    CHECK(plb_polygon_triangles(u, 8, &t, &err) && t.n == 18);
    CHECK_RANGE(area_of(u, &t), 13 - 1e-9, 13 + 1e-9);
    CHECK(plb_polygon_triangles(ring, 10, &t, &err) && t.n == 24);
    CHECK_RANGE(area_of(ring, &t), 72 - 1e-9, 72 + 1e-9);
    CHECK(plb_polygon_triangles(upright, 4, &t, &err) && t.n == 6);
    CHECK_RANGE(area_of(upright, &t), 1.5 - 1e-9, 1.5 + 1e-9);
    array_free(&t);
}

/* ---- edges ---- */

static const char cube[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

static void a_cube_has_twelve_edges(void)
{
    mesh m;
    CHECK(mesh_of_text(cube, &m));
    CHECK(m.triangles.n == 12 && m.places.n == 8 && m.edges.n == 18);
    CHECK(count_edges(&m, EDGE_CREASE) == 12 && count_edges(&m, EDGE_SMOOTH) == 6 && m.patches == 6);
    plb_mesh_free(&m);
}

/* The same faces again, turned inside out, places of their own for each face: still one cube. */
static void doubled_and_loose_faces_are_one(void)
{
    static const char loose[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 1 1 0.00000001\n"
                                "f 1 2 3\nf 1 9 4\nf 5 6 7 8\nf 1 3 2\nf 4 3 1\n";
    mesh m;
    CHECK(mesh_of_text(loose, &m));
    CHECK(m.triangles.n == 4 && m.places.n == 6);
    CHECK(count_edges(&m, EDGE_CREASE) == 1 && count_edges(&m, EDGE_BORDER) == 6);
    plb_mesh_free(&m);
}

/* A wall beside two halves of a wall: the place between the halves lies within its side. */
static void a_place_within_a_side_is_no_border(void)
{
    static const char wall[] = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 0 0\nv 4 1 0\nv 2 1 0\nv 4 2 0\n"
                               "f 1 2 3 4\nf 2 5 6 7\nf 7 6 8 3\n";
    mesh m;
    CHECK(mesh_of_text(wall, &m));
    CHECK(count_edges(&m, EDGE_BORDER) == 7 && count_edges(&m, EDGE_CREASE) == 0);
    plb_mesh_free(&m);
}

static void materials_have_borders(void)
{
    static const char two[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nusemtl red\nf 1 2 3 4\nusemtl blue\nf 2 5 6 3\n";
    mesh m;
    CHECK(mesh_of_text(two, &m));
    CHECK(count_edges(&m, EDGE_MATERIAL) == 1 && count_edges(&m, EDGE_BORDER) == 6);
    plb_mesh_free(&m);
}

/* A shell of two rows of triangles, folded by 40 degrees along a line that ends in its middle: a stray crease. Folded by 60, it is none. */
static size_t folds(double degrees)
{
    char text[4000];
    size_t n = 0;
    double up = tan(degrees / 2 * PLB_PI / 180);
    for (int i = 0; i <= 40; i++)
        for (int k = 0; k < 3; k++)
            n += (size_t)snprintf(text + n, sizeof text - n, "v %d %.6f %d\n", i, k == 1 && i < 3 ? up : 0., k);
    for (int i = 0; i < 40; i++)
        for (int k = 0; k < 2; k++) {
            int a = 3 * i + k + 1;
            n += (size_t)snprintf(text + n, sizeof text - n, "f %d %d %d %d\n", a, a + 3, a + 4, a + 1);
        }
    mesh m;
    CHECK(mesh_of_text(text, &m));
    size_t creases = count_edges(&m, EDGE_CREASE);
    plb_mesh_free(&m);
    return creases;
}

static void stray_creases_go(void)
{
    CHECK(folds(40) == 0);
    CHECK(folds(80) > 0);
}

/* ---- visibility ---- */

typedef struct {
    size_t samples, wrong;
    size_t seen; /* of the samples */
} tally;

/* Is the place on the piece behind some triangle? 1 yes, 0 no, -1: only behind one that is too near to tell. */
static int is_behind(const view *v, const line_piece *p, vector at, double tolerance)
{
    const mesh *m = v->m;
    int behind = 0;
    for (uint32_t t = 0; t < m->triangles.n && behind != 1; t++) {
        vector a = view_corner(v, t, 0), b = view_corner(v, t, 1), c = view_corner(v, t, 2);
        double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        double wa = ((b.x - at.x) * (c.y - at.y) - (b.y - at.y) * (c.x - at.x)) / area;
        double wb = ((c.x - at.x) * (a.y - at.y) - (c.y - at.y) * (a.x - at.x)) / area, wc = 1 - wa - wb;
        double rim = 1e-6 * v->m->size * v->scale * (fabs(a.x - b.x) + fabs(a.y - b.y) + fabs(a.x - c.x) + fabs(a.y - c.y)) / fabs(area);
        if (!(wa > -rim && wb > -rim && wc > -rim))
            continue;
        bool is_on_rim = !(wa > rim && wb > rim && wc > rim); /* two triangles share it, or none is behind it */
        double before = wa * a.z + wb * b.z + wc * c.z - at.z;
        if (before < tolerance / 2)
            continue;
        /* The surface that the line lies on is too near to tell: its own triangles and, of a contour, a triangle's length around. */
        double near = 2 * tolerance;
        if (p->kind == LINE_CONTOUR && m->patch.v[t] == m->patch.v[p->own[0]])
            near = 2 * greater(vector_distance(a, b), greater(vector_distance(b, c), vector_distance(c, a)));
        behind = before > near && !is_on_rim ? 1 : -1;
    }
    return behind;
}

static double distance_to_segment(point a, point b, point p)
{
    point d = point_sub(b, a), q = point_sub(p, a);
    double l2 = point_dot(d, d), t = l2 > 0 ? point_dot(q, d) / l2 : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return plb_point_distance(q, point_scale(d, t));
}

static bool lies_on_run(const run_list *l, bool hidden, point p, double reach)
{
    for (size_t i = 0; i < l->runs.n; i++) {
        const run *r = &l->runs.v[i];
        for (size_t k = 0; r->is_hidden == hidden && k + 1 < r->n + r->is_closed; k++)
            if (distance_to_segment(l->points.v[r->first + k], l->points.v[r->first + (k + 1) % r->n], p) <= reach)
                return true;
    }
    return false;
}

/* Looks at the model from a direction and compares places on its lines with what rays say. */
static bool compare(const mesh *m, direction_of_view from, tally *count)
{
    view v;
    line_pieces pieces = {0};
    chain_list chains = {0};
    box_tree tree = {0};
    run_list runs = {0};
    error err = {ERROR_NONE, ""};
    bool ok = plb_view_make(m, from, &v, &err);
    if (ok)
        plb_view_place(&v, 200 / m->size, 0, 0);
    ok = ok && plb_line_edges(&v, &pieces, &err) && plb_line_contours(&v, &pieces, &err) && plb_line_meetings(&v, &pieces, &err) &&
         plb_line_chain(&pieces, &chains, &err) && plb_tree_build(&tree, &v, true, &err) && plb_hide(&v, &tree, &pieces, &chains, true, &runs, &err);
    double tolerance = plb_hide_tolerance(&v);
    for (size_t i = 0; ok && i < pieces.n; i++) {
        const line_piece *p = &pieces.v[i];
        uint64_t key = random_key(7, i, PURPOSE_LINE);
        int n = 1 + (int)(hypot(p->to.x - p->from.x, p->to.y - p->from.y) / 2);
        for (int k = 0; k < n; k++) {
            vector at = vector_mix(p->from, p->to, (k + random_unit(key, (uint64_t)k)) / n);
            int behind = is_behind(&v, p, at, tolerance);
            if (behind < 0)
                continue;
            count->samples++;
            count->seen += !behind;
            /* The line's scraps and gaps of a tenth of a mm are closed. */
            count->wrong += !lies_on_run(&runs, behind, (point){at.x, at.y}, .16);
        }
    }
    plb_tree_free(&tree);
    plb_chain_list_free(&chains);
    plb_run_list_free(&runs);
    array_free(&pieces);
    plb_view_free(&v);
    return ok;
}

static const direction_of_view looks[] = {{35, 22, 0}, {0, 0, 0}, {45, 35.264389682754654, 0}, {-130, -20, 40}, {10, 80, 60}};

static void compare_all(const mesh *m, tally *count)
{
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++)
        CHECK(compare(m, looks[i], count));
    printf("# %zu samples, %zu seen, %zu wrong\n", count->samples, count->seen, count->wrong);
    CHECK(count->samples > 200 && count->seen > 50);
    CHECK((double)count->wrong <= .001 * (double)count->samples);
}

static void compare_example(const char *name)
{
    static char text[MOST];
    size_t n = load(name, text);
    mesh m;
    tally count = {0};
    CHECK(n > 0 && mesh_of(text, n, &m));
    if (n == 0)
        return;
    compare_all(&m, &count);
    plb_mesh_free(&m);
}

static void the_house_is_seen_as_by_rays(void) { compare_example("examples/models/house.obj"); }
static void the_bracket_is_seen_as_by_rays(void) { compare_example("examples/models/bracket.obj"); }
static void the_chair_is_seen_as_by_rays(void) { compare_example("examples/models/chair.obj"); }
static void the_knot_is_seen_as_by_rays(void) { compare_example("examples/models/knot.obj"); }

/* Boxes and single triangles that run through each other, some turned inside out, some open, some twice. */
static void a_heap_is_seen_as_by_rays(void)
{
    static char text[MOST];
    size_t n = 0;
    uint64_t key = random_key(3, 1, PURPOSE_LINE), next = 0;
    for (int i = 0; i < 40; i++) {
        double v[9];
        for (int k = 0; k < 9; k++)
            v[k] = random_unit(key, next++) * (k < 6 ? 10 : 4);
        int first = 8 * i;
        for (int k = 0; k < 8; k++) /* a slanted box */
            n += (size_t)snprintf(text + n, MOST - n, "v %.5f %.5f %.5f\n", v[0] + (k & 1) * v[6] + (k & 2) * .2, v[1] + (k & 2) * v[7] / 2, v[2] + (k & 4) * v[8] / 4 + (k & 1) * .3);
        static const int sides[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {2, 4, 8, 6}, {1, 5, 7, 3}};
        for (int k = i % 3 == 0; k < 6; k++) /* every third is open */
            for (int turned = 0; turned <= (i % 5 == 0); turned++)
                n += (size_t)(turned ? snprintf(text + n, MOST - n, "f %d %d %d %d\n", first + sides[k][3], first + sides[k][2], first + sides[k][1], first + sides[k][0])
                                     : snprintf(text + n, MOST - n, "f %d %d %d %d\n", first + sides[k][0], first + sides[k][1], first + sides[k][2], first + sides[k][3]));
    }
    mesh m;
    tally count = {0};
    CHECK(mesh_of(text, n, &m));
    compare_all(&m, &count);
    plb_mesh_free(&m);
}

/* From straight ahead the edges behind lie under those before: none of them is drawn, seen or hidden. */
static void hidden_lines_under_seen_ones_go(void)
{
    mesh m;
    view v;
    run_list runs = {0};
    error err = {ERROR_NONE, ""};
    CHECK(mesh_of_text(cube, &m) && plb_view_make(&m, looks[1], &v, &err));
    plb_view_place(&v, 100, 0, 0);
    CHECK(plb_view_lines(&v, true, &runs, &err));
    double seen = 0, hidden = 0;
    for (size_t i = 0; i < runs.runs.n; i++)
        for (size_t k = 0; k + 1 < runs.runs.v[i].n; k++)
            *(runs.runs.v[i].is_hidden ? &hidden : &seen) += plb_point_distance(runs.points.v[runs.runs.v[i].first + k], runs.points.v[runs.runs.v[i].first + k + 1]);
    CHECK_RANGE(seen, 399.9, 400.1);
    CHECK_RANGE(hidden, 0, .001);
    plb_run_list_free(&runs);
    plb_view_free(&v);
    plb_mesh_free(&m);
}

int main(void)
{
    RUN(ears_fill_a_polygon_and_not_its_dents);
    RUN(a_cube_has_twelve_edges);
    RUN(doubled_and_loose_faces_are_one);
    RUN(a_place_within_a_side_is_no_border);
    RUN(materials_have_borders);
    RUN(stray_creases_go);
    RUN(the_house_is_seen_as_by_rays);
    RUN(the_bracket_is_seen_as_by_rays);
    RUN(the_chair_is_seen_as_by_rays);
    RUN(the_knot_is_seen_as_by_rays);
    RUN(a_heap_is_seen_as_by_rays);
    RUN(hidden_lines_under_seen_ones_go);
    CHECK_EXIT;
}
