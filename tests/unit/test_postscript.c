/* SPDX-License-Identifier: MIT
 *
 * The PostScript reader: small programs and the display lists they must give, errors and how files catch them,
 * pages, limits. tests/hostile.sh has the hostile files.
 */
#include "check.h"
#include "tap/ps/postscript.h"


static display_list list;
static error fault;
static ps_answer answer;

static ps_outcome ask(ps_request what)
{
    plb_list_free(&list);
    plb_list_init(&list);
    plb_error_clear(&fault);
    return plb_ps_read(&what, &list, &answer, &fault);
}

static bool read_bytes(const char *data, size_t size)
{
    return ask((ps_request){.data = data, .size = size, .alone = true}) == PS_DRAWN;
}

static bool read_text(const char *text) { return read_bytes(text, strlen(text)); }

/* Is this among the warnings? */
static bool said(const char *words)
{
    for (int i = 0; answer.warnings[i]; i++)
        if (strstr(answer.warnings[i], words))
            return true;
    return false;
}

/* Runs the program in a page of 100 by 200 points. */
static bool draw(const char *program)
{
    char text[8192];
    snprintf(text, sizeof text, "%%!PS-Adobe-3.0 EPSF-3.0\n%%%%BoundingBox: 0 0 100 200\n%s\n", program);
    return read_text(text);
}

static double points(double mm) { return mm * 72 / 25.4; }

static bool near(double mm, double expected_points) { return fabs(points(mm) - expected_points) < 0.02; }

/* Point `k` of item `i` in points, y upwards. */
static bool at(size_t i, size_t k, double x, double y)
{
    if (i >= list.items.n || k >= list.items.v[i].path.points.n)
        return false;
    point p = list.items.v[i].path.points.v[k];
    return near(p.x, x) && near(list.height - p.y, y);
}

/* The program leaves `true` by drawing one line; anything else is its failure. */
static bool holds(const char *condition)
{
    char text[4096];
    snprintf(text, sizeof text, "%s { 0 0 moveto 1 1 lineto stroke } if", condition);
    bool good = draw(text) && list.items.n == 1;
    if (!good)
        printf("# %s: %s\n", condition, fault.text);
    return good;
}

static bool fails(const char *program, const char *words)
{
    bool failed = !draw(program);
    if (!failed || !strstr(fault.text, words))
        printf("# %s: %s\n", program, failed ? fault.text : "no error");
    return failed && strstr(fault.text, words) && !strchr(fault.text, '\n');
}

static void a_line_is_a_stroke(void)
{
    CHECK(draw("2 setlinewidth 1 setlinecap 10 20 moveto 30 40 lineto stroke showpage"));
    CHECK(list.items.n == 1 && list.items.v[0].kind == ITEM_STROKE && list.items.v[0].cap == LINE_CAP_ROUND);
    CHECK(near(list.width, 100) && near(list.height, 200) && near(list.items.v[0].width, 2));
    CHECK(at(0, 0, 10, 20) && at(0, 1, 30, 40));
}

static void paths_are_built(void)
{
    CHECK(draw("10 10 moveto 5 0 rlineto 0 5 rmoveto 1 1 2 2 3 3 rcurveto closepath 9 9 lineto stroke"));
    CHECK(at(0, 0, 10, 10) && at(0, 1, 15, 10) && at(0, 2, 15, 15) && at(0, 5, 18, 18) && at(0, 6, 9, 9));
    CHECK(draw("50 50 10 0 90 arc stroke 50 50 10 90 0 arcn stroke"));
    CHECK(at(0, 0, 60, 50) && at(0, 3, 50, 60) && at(1, 0, 50, 60) && at(1, 3, 60, 50));
    CHECK(draw("50 50 10 270 90 arc stroke 50 50 10 0 360 arc stroke"));
    CHECK(at(0, 6, 50, 60) && list.items.v[1].path.points.n == 13);
    CHECK(draw("0 0 moveto 10 0 10 10 2 arcto stroke pop pop 0 eq exch 8 eq and { 9 9 moveto 1 1 lineto stroke } if"));
    CHECK(at(0, 1, 8, 0) && at(0, 4, 10, 2) && list.items.n == 2);
    CHECK(draw("0 0 moveto 10 0 20 0 2 arct stroke"));
    CHECK(at(0, 1, 10, 0));
    CHECK(draw("1 2 3 4 rectfill [1 2 3 4 5 6 7 8] rectstroke"));
    CHECK(list.items.v[0].kind == ITEM_FILL && at(0, 2, 4, 6) && list.items.v[1].path.points.n == 8);
}

static void matrices_compose(void)
{
    CHECK(draw("10 20 translate 2 3 scale 90 rotate 1 0 moveto 0 1 lineto stroke"));
    CHECK(at(0, 0, 10, 23) && at(0, 1, 8, 20));
    CHECK(draw("[2 0 0 2 5 5] concat 1 1 moveto gsave 3 3 translate 1 1 lineto stroke grestore 2 2 lineto stroke"));
    CHECK(at(0, 0, 7, 7) && at(0, 1, 13, 13) && at(1, 0, 7, 7) && at(1, 1, 9, 9));
    CHECK(holds("2 3 scale 1 1 transform 1 1 dtransform 3 -1 roll eq 3 1 roll eq and"));
    CHECK(holds("matrix defaultmatrix pop 5 7 translate 12 34 transform itransform 34 sub abs 1e-6 lt exch 12 sub abs 1e-6 lt and"));
    CHECK(holds("[2 0 0 4 1 1] matrix invertmatrix 3 get 0.25 eq"));
    CHECK(holds("gstate 5 setlinewidth setgstate currentlinewidth 1 eq"));
}

static void pens_follow_the_matrix(void)
{
    CHECK(draw("4 9 scale 2 setlinewidth [1 2 3] 0.5 setdash 0 0 moveto 1 1 lineto stroke"));
    CHECK(near(list.items.v[0].width, 12) && list.items.v[0].dash.n == 6);
    CHECK(near(list.items.v[0].dash.v[2], 18) && near(list.items.v[0].dash.v[3], 6) && near(list.items.v[0].dash_offset, 3));
}

static void colours_become_red_green_blue(void)
{
    static const struct {
        const char *program;
        double red, green, blue;
    } all[] = {
        {"0.5 setgray", 0.5, 0.5, 0.5},
        {"1 0.5 0 setrgbcolor", 1, 0.5, 0},
        {"0.1 0.2 0.3 0.4 setcmykcolor", 0.5, 0.4, 0.3},
        {"0 1 1 sethsbcolor", 1, 0, 0},
        {"1 3 div 1 0.5 sethsbcolor", 0, 0.5, 0},
        {"/DeviceRGB setcolorspace 0 1 0 setcolor", 0, 1, 0},
        {"[/Indexed /DeviceRGB 1 <000000ff0000>] setcolorspace 1 setcolor", 1, 0, 0},
        {"[/Separation /Spot /DeviceCMYK { dup 0 exch 0 exch 0 }] setcolorspace 1 setcolor", 1 - 0, 1 - 1, 1 - 1},
        {"[/ICCBased << /N 1 >>] setcolorspace 0.25 setcolor", 0.25, 0.25, 0.25},
        {"/DeviceCMYK setcolorspace", 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        char text[300];
        snprintf(text, sizeof text, "%s 0 0 1 1 rectfill", all[i].program);
        bool good = draw(text) && list.items.n == 1;
        CHECK(good);
        if (good && i != 7) {
            CHECK_RANGE(list.items.v[0].paint.red, all[i].red - 1e-6, all[i].red + 1e-6);
            CHECK_RANGE(list.items.v[0].paint.green, all[i].green - 1e-6, all[i].green + 1e-6);
            CHECK_RANGE(list.items.v[0].paint.blue, all[i].blue - 1e-6, all[i].blue + 1e-6);
        }
    }
}

static void clips_nest(void)
{
    CHECK(draw("0 0 50 50 rectclip gsave 10 10 20 20 rectclip 0 0 moveto 9 9 lineto stroke grestore "
               "0 0 moveto 9 9 lineto stroke initclip 0 0 moveto 9 9 lineto stroke"));
    CHECK(list.clips.n == 2 && list.clips.v[1].parent == 0 && list.clips.v[0].parent == NO_CLIP);
    CHECK(list.items.n == 3 && list.items.v[0].clip == 1 && list.items.v[1].clip == 0 && list.items.v[2].clip == NO_CLIP);
    CHECK(draw("newpath clip 0 0 moveto 9 9 lineto stroke"));
    CHECK(list.items.n == 0);
    CHECK(holds("10 20 30 40 rectclip clippath pathbbox 60 sub abs 0.01 lt 4 1 roll pop pop pop"));
}

static void control_works(void)
{
    CHECK(holds("0 1 1 10 { add } for 55 eq"));
    CHECK(holds("0 10 -2 1 { add } for 30 eq"));
    CHECK(holds("0 5 { 1 add } repeat 5 eq"));
    CHECK(holds("0 { 1 add dup 7 eq { exit } if } loop 7 eq"));
    CHECK(holds("0 [1 2 3] { add } forall 6 eq"));
    CHECK(holds("0 (ab) { add } forall 195 eq"));
    CHECK(holds("0 << /a 1 /b 2 >> { exch pop add } forall 3 eq"));
    CHECK(holds("1 2 lt { true } { false } ifelse"));
    CHECK(holds("/f { dup 0 eq { pop 1 } { dup 1 sub f mul } ifelse } def 5 f 120 eq"));
    CHECK(holds("(1 2 add) cvx exec 3 eq"));
    CHECK(holds("{ stop } stopped"));
    CHECK(holds("{ 1 } stopped not exch 1 eq and"));
}

static void arithmetic_is_right(void)
{
    CHECK(holds("7 2 idiv 3 eq 7 2 mod 1 eq and -7 2 mod -1 eq and 7 2 div 3.5 eq and"));
    CHECK(holds("2147483647 1 add type /realtype eq 1 1 add type /integertype eq and"));
    CHECK(holds("2.5 round 3 eq -2.5 round -2 eq and 2.7 truncate 2 eq and -2.1 floor -3 eq and 2.1 ceiling 3 eq and"));
    CHECK(holds("90 sin 1 eq 180 cos -1 eq and 1 0 atan 90 eq and 0 -1 atan 180 eq and -1 0 atan 270 eq and"));
    CHECK(holds("9 sqrt 3 eq 2 10 exp 1024 eq and 100 log 2 eq and 1 ln 0 eq and"));
    CHECK(holds("5 3 and 1 eq 5 3 or 7 eq and 5 3 xor 6 eq and 0 not -1 eq and 1 4 bitshift 16 eq and 16 -4 bitshift 1 eq and"));
    CHECK(holds("42 srand rand rand 42 srand rand rand 3 1 roll pop eq exch pop"));
    CHECK(holds("(abc) (abd) lt (abc) /abc eq and 1 1.0 eq and"));
}

static void stacks_arrays_and_dictionaries_work(void)
{
    CHECK(holds("1 2 3 3 1 roll 2 eq exch 1 eq and exch 3 eq and"));
    CHECK(holds("1 2 3 2 copy 3 eq exch 2 eq and 4 1 roll pop pop pop"));
    CHECK(holds("mark 1 2 3 counttomark 3 eq 5 1 roll cleartomark"));
    CHECK(holds("[1 2 3] aload length 3 eq 4 1 roll pop pop pop"));
    CHECK(holds("[1 [2 3] 4] dup 1 get 1 get 3 eq exch length 3 eq and"));
    CHECK(holds("1 2 3 3 array astore 2 get 3 eq"));
    CHECK(holds("[1 2 3 4] 1 2 getinterval aload pop 3 eq exch 2 eq and"));
    CHECK(holds("5 array dup 1 [7 8] putinterval 2 get 8 eq"));
    CHECK(holds("/x 5 def /x load 5 eq 1 dict begin /x 6 def x 6 eq end and x 5 eq and"));
    CHECK(holds("/x 5 def 1 dict begin /x 9 store end x 9 eq"));
    CHECK(holds("/moveto where { pop true } { false } ifelse /nosuchname where not and systemdict /stroke known and"));
    CHECK(holds("/d 100 dict def 0 1 99 { d exch dup dup mul put } for d 50 get 2500 eq"));
    CHECK(holds("<< (key) 1 >> /key get 1 eq"));
    CHECK(holds("/x 1 def save /x 2 def restore x 1 eq"));
    CHECK(holds("/a [1] def save pop 5 dict dup /k 1 put dup /k undef /k known not"));
}

static void strings_work(void)
{
    CHECK(holds("(abcd) (bc) search { pop pop (d) eq } { false } ifelse"));
    CHECK(holds("(abcd) (ab) anchorsearch { pop (cd) eq } { false } ifelse"));
    CHECK(holds("12.5 10 string cvs (12.5) eq 7 3 string cvs (7) eq and 2 10 string cvs (2) eq and 3.0 9 string cvs (3.0) eq and"));
    CHECK(holds("255 16 4 string cvrs (FF) eq"));
    CHECK(holds("(12) cvi 12 eq (1.5) cvr 1.5 eq and 3.9 cvi 3 eq and (abc) cvn /abc eq and"));
    CHECK(holds("({a b} rest) token { length 2 eq exch ( rest) eq and } { false } ifelse"));
    CHECK(holds("5 string dup 0 65 put 0 get 65 eq"));
    CHECK(holds("{a} type /arraytype eq {a} xcheck and /a xcheck not and"));
}

static void the_file_can_be_read_by_its_program(void)
{
    CHECK(holds("/s 20 string def currentfile s readline\nhello world\npop (hello world) eq"));
    CHECK(holds("currentfile 3 string readhexstring\n41 42 43\npop (ABC) eq"));
    CHECK(holds("currentfile 3 string readstring\nABC pop (ABC) eq"));
    CHECK(draw("4 4 8 [4 0 0 4 0 0] { currentfile 16 string readhexstring pop } image\n"
               "00112233445566778899aabbccddeeff\n0 0 moveto 1 1 lineto stroke"));
    CHECK(list.omissions.n[OMISSION_IMAGE] == 1 && list.items.n == 1);
    CHECK(draw("1 1 moveto << /ImageType 1 /Width 2 /Height 2 /BitsPerComponent 8 /ImageMatrix [2 0 0 2 0 0] /Decode [0 1]\n"
               "/DataSource currentfile >> image\nabcd\n2 2 lineto stroke"));
    CHECK(list.omissions.n[OMISSION_IMAGE] == 1 && list.items.n == 1);
}

static void letters_are_left_out_but_counted(void)
{
    CHECK(draw("/Helvetica findfont 10 scalefont setfont 10 10 moveto (Hello) show 0 5 rlineto stroke"));
    CHECK(list.omissions.n[OMISSION_TEXT] == 1);
    CHECK(list.items.n == 1 && at(0, 0, 10 + 5 * 5.56, 10));
    CHECK(holds("/Courier 10 selectfont (abc) stringwidth pop 16.68 sub abs 1e-6 lt"));
}

static void glyphs_of_type_3_are_drawn(void)
{
    CHECK(draw("/T << /FontType 3 /FontMatrix [0.1 0 0 0.1 0 0] /FontBBox [0 0 10 10] /Encoding StandardEncoding "
               "/BuildChar { exch pop 97 eq { 6 0 setcharwidth 0 0 moveto 5 5 lineto stroke } { 2 0 setcharwidth } ifelse } >> "
               "definefont 10 scalefont setfont 20 30 moveto (aba) show currentpoint pop 34 sub abs 1e-6 lt "
               "{ 1 1 moveto 2 2 lineto stroke } if"));
    CHECK(list.items.n == 3 && at(0, 0, 20, 30) && at(0, 1, 25, 35) && at(1, 0, 28, 30));
    CHECK(!answer.warnings[0]);
}

static void errors_can_be_caught(void)
{
    CHECK(holds("{ nosuchoperator } stopped $error /errorname get /undefined eq and"));
    CHECK(holds("{ 1 0 div } stopped exch pop exch pop"));
    CHECK(holds("{ (x) 1 add } stopped 3 1 roll pop pop"));
    CHECK(holds("errordict /rangecheck { pop stop } put { -1 array } stopped exch pop"));
    CHECK(holds("{ (f) (r) file } stopped 3 1 roll pop pop"));
}

static void errors_name_line_and_operator(void)
{
    CHECK(fails("1 2\nxyzzy", "4: the PostScript operator 'xyzzy' is not known"));
    CHECK(fault.kind == ERROR_UNSUPPORTED);
    CHECK(fails("\n\nadd", "5: stackunderflow in 'add'"));
    CHECK(fault.kind == ERROR_SYNTAX);
    CHECK(fails("/f {\n  pop\n} def\n\n\nf", "4: stackunderflow in 'pop'"));
    CHECK(fails("(a) 1 add", "typecheck in 'add'"));
    CHECK(fails("5 (abc", "3: the string that starts here never ends"));
    CHECK(fails("(x) run", "the operator 'run' is refused"));
    CHECK(fails("{} loop", "runs for more than"));
    CHECK(fault.kind == ERROR_LIMIT);
}

static void pages_come_from_where_the_file_says(void)
{
    static const struct {
        const char *text;
        double width, height;
    } all[] = {
        {"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 10 20 110 220\n0 0 9 9 rectfill", 100, 200},
        {"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 10 20 110 220\n%%HiResBoundingBox: 10.5 20.5 109.5 219.5\n", 99, 199},
        {"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: (atend)\n0 0 9 9 rectfill\n%%Trailer\n%%BoundingBox: 0 0 50 60\n", 50, 60},
        {"%!PS-Adobe-3.0 EPSF-3.0\n%%BeginDocument: x\n%%BoundingBox: 0 0 1 1\n%%EndDocument\n%%BoundingBox: 0 0 50 60\n", 50, 60},
        {"%!PS\n0 0 moveto 10 10 lineto stroke", 595, 842},
        {"%!PS\n<< /PageSize [300 400] >> setpagedevice 0 0 9 9 rectfill", 300, 400},
        {"%!PS\n%%DocumentMedia: x 200 300 0 () ()\n0 0 9 9 rectfill", 200, 300},
        {"%!PS\na3 0 0 9 9 rectfill", 842, 1191},
        {"%!PS\n2000 2000 moveto 2100 2050 lineto stroke", 110, 60},
        {"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 2000000000 2000000000\n0 0 moveto 20 10 lineto stroke", 30, 20},
        {"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 0 0\n0 0 moveto 20 10 lineto stroke", 595, 842},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        CHECK(read_text(all[i].text));
        CHECK_RANGE(points(list.width), all[i].width - 0.01, all[i].width + 0.01);
        CHECK_RANGE(points(list.height), all[i].height - 0.01, all[i].height + 0.01);
    }
}

static void only_the_first_page_is_drawn(void)
{
    CHECK(read_text("%!PS\nshowpage 0 0 9 9 rectfill showpage\n%%Page: 2 2\n0 0 9 9 rectfill showpage\n"));
    CHECK(list.items.n == 1 && said("only the first page"));
    CHECK(draw("0 0 9 9 rectfill erasepage 1 1 2 2 rectfill"));
    CHECK(list.items.n == 1 && at(0, 0, 1, 1));
}

/* Pages are those that a program shows, whatever words stand in it. */
static void other_pages_are_noticed(void)
{
    static const char loop[] = "%!PS\n3 { 0 0 moveto 99 99 lineto stroke showpage } repeat";
    CHECK(read_text(loop) && list.items.n == 1 && said("only the first page"));
    CHECK(ask((ps_request){.data = loop, .size = strlen(loop), .alone = true, .only_count = true}) == PS_DRAWN && answer.pages == 3);
    CHECK(ask((ps_request){.data = loop, .size = strlen(loop), .page = 4}) == PS_DRAWN && answer.pages == 3);
    CHECK(ask((ps_request){.data = loop, .size = strlen(loop), .page = 3}) == PS_DRAWN && list.items.n == 1 && !answer.warnings[0]);
    CHECK(read_text("%!PS\n/endpage { showpage } def 0 0 9 9 rectfill endpage\n0 0 9 9 rectclip /showpage load pop") && !answer.warnings[0]);
    CHECK(list.clips.n == 0 && list.items.n == 1);
    CHECK(read_text("%!PS\n0 0 9 9 rectfill showpage {} loop") && list.items.n == 1 && !answer.warnings[0]);
    CHECK(read_text("%!PS\n0 0 9 9 rectfill showpage nosuchoperator") && list.items.n == 1 && !answer.warnings[0]);
    CHECK(read_text("%!PS\n0 0 9 9 rectfill showpage erasepage /Helvetica findfont setfont 9 9 moveto (x) show"));
    CHECK(list.items.n == 1 && !list.omissions.n[OMISSION_TEXT] && said("only the first page"));
}

/* Operators that Ghostscript draws end the reading at once, if the comments say what the page is; else with the page. */
static void fonts_filters_and_resources_are_left_to_ghostscript(void)
{
#define EPS "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 10 20 110 220\n"
#define SET "/Helvetica findfont 10 scalefont setfont 9 9 moveto "
    static const char *const all[] = {
        EPS SET "(x) show {} loop", EPS SET "(x) false charpath {} loop", EPS "<< /ShadingType 2 >> shfill {} loop",
        EPS "(00>) /ASCIIHexDecode filter {} loop", EPS "/x /Font findresource {} loop", EPS "/x /y /z defineresource {} loop",
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        CHECK(ask((ps_request){.data = all[i], .size = strlen(all[i])}) == PS_HANDED_OVER);
        CHECK(answer.sheet == 1 && answer.lacks_showpage && answer.area.x0 == 10 && answer.area.y1 == 220 && fault.kind);
    }
    static const char later[] = "%!PS\n" SET "(x) show showpage " SET "(y) show << /PageSize [70 80] >> setpagedevice showpage";
    CHECK(ask((ps_request){.data = later, .size = strlen(later), .page = 2}) == PS_HANDED_OVER);
    CHECK(answer.sheet == 2 && answer.area.x1 == 70 && answer.area.y1 == 80);
    CHECK(ask((ps_request){.data = later, .size = strlen(later)}) == PS_HANDED_OVER && said("only the first page"));
    static const char unshown[] = "%!PS\n0 0 moveto 9 9 lineto stroke showpage " SET "\n(x) show";
    CHECK(ask((ps_request){.data = unshown, .size = strlen(unshown), .page = 2}) == PS_HANDED_OVER);
    CHECK(answer.sheet == 2 && answer.lacks_showpage && strstr(fault.text, "3: 'show' is left"));
    CHECK(ask((ps_request){.data = later, .size = strlen(later), .only_count = true}) == PS_DRAWN && answer.pages == 2);
    CHECK(fails("/x /y findresource", "the PostScript operator 'findresource' is not known"));
    CHECK(holds("{ /x /y findresource } stopped 3 1 roll pop pop"));
}

static void a_binary_header_is_stripped(void)
{
    static const char program[] = "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 30 40\n0 0 9 9 rectfill\n";
    char text[256] = "\xc5\xd0\xd3\xc6";
    text[4] = 30;
    text[8] = (char)(sizeof program - 1);
    memcpy(text + 30, program, sizeof program - 1);
    memcpy(text + 30 + sizeof program - 1, "II*junk", 7);
    CHECK(read_bytes(text, 30 + sizeof program - 1 + 7));
    CHECK(list.items.n == 1 && near(list.width, 30));
    CHECK(!read_bytes(text, 30) && strstr(fault.text, "no PostScript"));
}

int main(void)
{
    plb_list_init(&list);
    RUN(a_line_is_a_stroke);
    RUN(paths_are_built);
    RUN(matrices_compose);
    RUN(pens_follow_the_matrix);
    RUN(colours_become_red_green_blue);
    RUN(clips_nest);
    RUN(control_works);
    RUN(arithmetic_is_right);
    RUN(stacks_arrays_and_dictionaries_work);
    RUN(strings_work);
    RUN(the_file_can_be_read_by_its_program);
    RUN(letters_are_left_out_but_counted);
    RUN(glyphs_of_type_3_are_drawn);
    RUN(errors_can_be_caught);
    RUN(errors_name_line_and_operator);
    RUN(pages_come_from_where_the_file_says);
    RUN(only_the_first_page_is_drawn);
    RUN(other_pages_are_noticed);
    RUN(fonts_filters_and_resources_are_left_to_ghostscript);
    RUN(a_binary_header_is_stripped);
    plb_list_free(&list);
    CHECK_EXIT;
}
