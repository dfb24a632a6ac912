// SPDX-License-Identifier: MIT
// Compares the module with the program: node same.mjs WEB DIR. DIR holds for each NAME the display list NAME.list, the program's
// picture NAME.png and the settings, NAME.json, that both got. Each case is one line, as tests/check.sh prints them.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { readPng } from './png.mjs';

const [web, dir] = process.argv.slice(2);
const { Plumbago, PlumbagoError } = await import(pathToFileURL(path.resolve(web, 'plumbago.js')));
const plumbago = await Plumbago.load();

const say = (name, why) => console.log(why ? `FAIL ${name}: ${why}` : `ok ${name}`);

async function compare(name) {
    const settings = JSON.parse(fs.readFileSync(path.join(dir, `${name}.json`), 'utf8'));
    const drawing = await plumbago.drawing(fs.readFileSync(path.join(dir, `${name}.list`)), settings);
    const want = readPng(fs.readFileSync(path.join(dir, `${name}.png`)));
    // Bands of an odd height come together to the whole page.
    const got = new Uint8ClampedArray(want.pixels.length);
    for (let top = 0; top < drawing.pixelHeight; top += 97) {
        const rows = Math.min(97, drawing.pixelHeight - top);
        got.set(drawing.pixels({ top, rows }), top * drawing.pixelWidth * 4);
    }
    let wrong = want.width !== drawing.pixelWidth || want.height !== drawing.pixelHeight ? 'another size' : '';
    for (let i = 0, n = 0; !wrong && i < got.length; i++)
        if (got[i] !== want.pixels[i])
            wrong = `byte ${i} is ${got[i]}, not ${want.pixels[i]}`;
    drawing.free();
    return wrong;
}

const names = fs.readdirSync(dir).filter(f => f.endsWith('.json')).map(f => f.slice(0, -5));
for (const name of names)
    say(`the module draws as the program: ${name}`, await compare(name));
say('at least 20 drawings are compared', names.length < 20 ? `${names.length}` : '');

// The comparison can tell: another seed is another picture.
const json = path.join(dir, `${names[0]}.json`), settings = fs.readFileSync(json, 'utf8');
fs.writeFileSync(json, JSON.stringify({ ...JSON.parse(settings), seed: 77 }));
say('another seed is told apart', (await compare(names[0])) ? '' : 'the same bytes');
fs.writeFileSync(json, settings);

// What is wrong is thrown with the program's words.
async function refuses(name, pattern, call) {
    try {
        await call();
        say(name, 'nothing was thrown');
    } catch (e) {
        say(name, e instanceof PlumbagoError && pattern.test(e.message) ? '' : `${e}`);
    }
}
const empty = 'plumbago-list 1\npage 20 10\nend\n';
await refuses('a list that is none', /list:1: /, () => plumbago.drawing('nonsense'));
await refuses('a list cut short', /list:\d+: /, () => plumbago.drawing('plumbago-list 1\npage 20 10\n'));
await refuses('a setting that is none', /pensil/, () => plumbago.drawing(empty, { pensil: 'HB' }));
await refuses('a value that is none', /seed/, () => plumbago.drawing(empty, { seed: 'x' }));
await refuses('a pencil that is none', /9B/, () => plumbago.drawing(empty, { pencil: '9B' }));
await refuses('rows beside the page', /rows/, async () => (await plumbago.drawing(empty)).pixels({ top: -1, rows: 4 }));

// Warnings reach the page.
const heard = [];
plumbago.onmessage = (level, text) => level === 0 && heard.push(text);
await plumbago.drawing(empty);
say('an empty page is warned of', heard.some(t => /page is empty/.test(t)) ? '' : heard.join('|') || 'silence');
plumbago.onmessage = null;

// Progress is told, and stops the work.
const drawing = await plumbago.drawing(fs.readFileSync(path.join(dir, `${names[0]}.list`)), { dpi: 96 });
const told = [];
drawing.pixels({ progress: done => void told.push(done) });
say('progress ends with 1', told.at(-1) === 1 ? '' : told.join(' '));
await refuses('progress stops the work', /./, async () => drawing.pixels({ progress: () => false }));

// Strokes are paths in mm on the page.
const stroke = drawing.stroke(0);
const inside = stroke && stroke.points.length >= 4 && stroke.points.every((v, i) => v > -5 && v < (i % 2 ? drawing.height : drawing.width) + 5);
say('a stroke is a path on the page', inside && drawing.stroke(drawing.strokes) === null ? '' : JSON.stringify(stroke));

// The memory of drawings that are freed is used again: the core does not grow.
const before = plumbago.memoryBytes;
for (let i = 0; i < 40; i++) {
    const again = await plumbago.drawing(fs.readFileSync(path.join(dir, `${names[0]}.list`)), { dpi: 50, seed: i });
    again.pixels();
    again.free();
}
say('memory stays flat over 40 drawings', plumbago.memoryBytes === before ? '' : `${before} to ${plumbago.memoryBytes} bytes`);

// Shapes of a sheet are lines of a list that the core reads; what is no number or colour is refused.
const sheet = plumbago.sheet(60, 40)
    .line(2, 2, 58, 2, { dash: [2, 1] })
    .linearPath([[2, 5], [20, 8], [30, 5]])
    .polygon([[40, 5], [50, 5], [45, 12]], { fill: '#888', hatch: 45 })
    .rectangle(5, 10, 20, 10, { stroke: null, fill: [0.2, 0.2, 0.2] })
    .ellipse(45, 22, 20, 10)
    .circle(15, 30, 12, { fill: '#336699', stroke: '#c00' })
    .arc(45, 32, 16, 10, 0, 4, true)
    .curve([[30, 38], [35, 30], [40, 38], [58, 36]]);
const drawn = await sheet.draw({ dpi: 100, colour: true });
const ink = drawn.pixels();
// Whether some pixel within a mm of (x, y) mm is darker than `grey`.
const isMarked = (x, y) => {
    const mm = 100 / 25.4;
    for (let v = Math.round((y - 1) * mm); v <= (y + 1) * mm; v++)
        for (let u = Math.round((x - 1) * mm); u <= (x + 1) * mm; u++)
            if (ink[(v * drawn.pixelWidth + u) * 4 + 1] < 215)
                return true;
    return false;
};
for (const [what, x, y] of [['linearPath', 20, 8], ['polygon', 45, 8], ['rectangle', 15, 15], ['ellipse', 55, 22], ['circle', 15, 36], ['arc', 45, 37], ['curve', 35, 30]])
    say(`a sheet's ${what} is drawn`, isMarked(x, y) ? '' : `nothing at ${x}, ${y}`);
say('the paper beside stays white', isMarked(30, 24) ? 'a mark at 30, 24' : '');
await refuses('a place that is no number', /NaN/, () => plumbago.sheet(10, 10).line(0, NaN, 1, 1));
await refuses('a colour that is none', /mauve/, () => plumbago.sheet(10, 10).circle(5, 5, 5, { stroke: 'mauve' }));
