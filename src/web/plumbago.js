// SPDX-License-Identifier: MIT
//
// Plumbago in a web page or in Node: drawings become pencil drawings, with the bytes that the program makes. Nothing leaves the machine.
// src/web/README.md is the manual. Lengths are millimetres on paper unless a name says otherwise.

const encoder = new TextEncoder(), decoder = new TextDecoder();

// What wasi-libc asks for where there is no system: every call says that it is not possible (ENOSYS, 52).
const noSystem = new Proxy({}, { get: () => () => 52 });

async function readBeside(name, base) {
    const url = new URL(name, base);
    if (url.protocol === 'file:' && typeof process !== 'undefined' && process.versions?.node) {
        const fs = await import('node:fs/promises');
        return new Uint8Array(await fs.readFile(url));
    }
    const answer = await fetch(url);
    if (!answer.ok)
        throw new Error(`${url}: ${answer.status}`);
    return new Uint8Array(await answer.arrayBuffer());
}

/** Is thrown where the core refuses; the message is the line that the program would print. */
export class PlumbagoError extends Error {}

export class Plumbago {
    #core;
    #read;
    #progress = null;
    #pencils = new Map(); // options with the defaults and that pencil
    /** Takes warnings (level 0) and details (level 1); null: they are dropped. */
    onmessage = null;

    /**
     * Loads the core. `base` is the address of the folder with plumbago.wasm and the pencils (default: beside this file);
     * `read(name)` replaces reading from there: it returns (a promise of) the file's bytes.
     */
    static async load({ base = import.meta.url, read = name => readBeside(name, base) } = {}) {
        const p = new Plumbago();
        p.#read = read;
        const imports = {
            wasi_snapshot_preview1: noSystem,
            plumbago: {
                message: (level, text, size) => p.onmessage?.(level, p.#text(text, size)),
                progress: done => (p.#progress?.(done) === false ? 0 : 1),
            },
        };
        const { instance } = await WebAssembly.instantiate(await read('plumbago.wasm'), imports);
        p.#core = instance.exports;
        p.#core._initialize?.();
        await p.pencil('HB');
        return p;
    }

    #bytes() {
        return new Uint8Array(this.#core.memory.buffer);
    }

    #text(at, size) {
        const bytes = this.#bytes();
        return decoder.decode(bytes.slice(at, size === undefined ? bytes.indexOf(0, at) : at + size));
    }

    #new(size) {
        const at = this.#core.web_new(size);
        if (!at)
            throw new PlumbagoError('out of memory');
        return at;
    }

    // Puts bytes, and a zero behind them, into the core's memory.
    #put(bytes) {
        const at = this.#new(bytes.length + 1);
        this.#bytes().set(bytes, at);
        return at;
    }

    /** The bytes of memory that the core has taken so far. */
    get memoryBytes() {
        return this.#core.memory.buffer.byteLength;
    }

    #fail() {
        throw new PlumbagoError(this.#text(this.#core.web_error()));
    }

    /** Fetches the file of a grade, once; drawings do it themselves for the pencils that they need. */
    async pencil(grade) {
        const data = await this.#read(`${grade}.pencil`);
        const name = this.#put(encoder.encode(grade));
        const good = this.#core.web_pencil(name, this.#put(data), data.length);
        this.#core.web_free(name);
        if (!good)
            throw new PlumbagoError(`${grade}: not one of the eight pencils`);
    }

    // Fetches the pencil that a call missed and calls again; the core asks for each of the eight once at most.
    async #withPencils(call) {
        for (let tries = 0; tries < 9; tries++) {
            const result = call();
            if (result)
                return result;
            const missing = this.#core.web_missing();
            if (!missing)
                this.#fail();
            await this.pencil(this.#text(missing));
        }
        return this.#fail();
    }

    async #set(o, name, value) {
        const n = this.#put(encoder.encode(name)), v = this.#put(encoder.encode(value === true ? 'on' : value === false ? 'off' : String(value)));
        try {
            await this.#withPencils(() => this.#core.web_set(o, n, v));
        } finally {
            this.#core.web_free(n);
            this.#core.web_free(v);
        }
    }

    // Returns options of the core, which have these settings and share the pencil with all others of its name: a pencil is made ready once.
    async #options({ pencil = 'HB', ...settings }) {
        const core = this.#core;
        if (!this.#pencils.has(pencil)) {
            const first = core.web_options(0);
            try {
                await this.#set(first, 'pencil', pencil);
            } catch (e) {
                core.web_options_free(first);
                throw e;
            }
            if (this.#pencils.has(pencil)) // another call was faster
                core.web_options_free(first);
            else
                this.#pencils.set(pencil, first);
        }
        const o = core.web_options(this.#pencils.get(pencil));
        if (!o)
            throw new PlumbagoError('out of memory');
        try {
            for (const [name, value] of Object.entries(settings))
                await this.#set(o, name, value);
        } catch (e) {
            core.web_options_free(o);
            throw e;
        }
        return o;
    }

    /** Makes an empty sheet of so many mm, on which shapes are put one by one. */
    sheet(width, height) {
        return new Sheet(this, width, height);
    }

    /**
     * Plans the drawing of a display list's text, plumbago-list(5). `settings` are those of the command line by their
     * long names: {pencil: '3B', seed: 7, dpi: 150}. The caller frees the result.
     */
    async drawing(list, settings = {}) {
        const o = await this.#options(settings), core = this.#core;
        const bytes = typeof list === 'string' ? encoder.encode(list) : list, text = this.#put(bytes);
        let d = 0;
        try {
            d = await this.#withPencils(() => core.web_draw(text, bytes.length, o));
        } finally {
            core.web_free(text);
            if (!d)
                core.web_options_free(o);
        }
        return new Drawing(this, core, d, o, () => this.#fail(), f => (this.#progress = f));
    }
}

/** A drawing that is planned: it can be drawn many times. */
export class Drawing {
    #core;
    #d;
    #o;
    #fail;
    #watch;

    constructor(plumbago, core, d, o, fail, watch) {
        this.#core = core;
        this.#d = d;
        this.#o = o;
        this.#fail = fail;
        this.#watch = watch;
        const at = core.web_new(40);
        try {
            if (!at || !core.web_page(d, o, at))
                fail();
            [this.width, this.height, this.pixelWidth, this.pixelHeight, this.strokes] = new Float64Array(core.memory.buffer, at, 5);
        } catch (e) {
            this.free();
            throw e;
        } finally {
            core.web_free(at);
        }
    }

    /** Gives back the core's memory; the drawing is of no use afterwards. */
    free() {
        this.#core.web_drawing_free(this.#d);
        this.#core.web_options_free(this.#o);
        this.#d = this.#o = 0;
    }

    /**
     * Draws `rows` rows from row `top` (all, where neither is given) and returns their pixels: red, green, blue, alpha. `progress` gets
     * 0 to 1; where it returns false, the call fails.
     */
    pixels({ top = 0, rows = this.pixelHeight - top, progress = null } = {}) {
        if (!this.#d)
            throw new PlumbagoError('the drawing is freed');
        if (!Number.isInteger(top) || !Number.isInteger(rows) || top < 0 || rows < 1 || top + rows > this.pixelHeight)
            throw new PlumbagoError(`the page has rows 0 to ${this.pixelHeight - 1}`);
        const size = this.pixelWidth * rows * 4, at = this.#core.web_new(size);
        if (!at)
            throw new PlumbagoError('out of memory');
        this.#watch(progress);
        try {
            if (!this.#core.web_render(this.#d, this.#o, at, this.pixelWidth, top, rows))
                this.#fail();
            return new Uint8ClampedArray(this.#core.memory.buffer.slice(at, at + size));
        } finally {
            this.#watch(null);
            this.#core.web_free(at);
        }
    }

    /** Draws onto a canvas, which takes the picture's size, in bands, so that the page stays alive; `progress` as in pixels(). */
    async drawOn(canvas, { band = 256, progress = null } = {}) {
        canvas.width = this.pixelWidth;
        canvas.height = this.pixelHeight;
        const context = canvas.getContext('2d');
        for (let top = 0; top < this.pixelHeight; top += band) {
            const rows = Math.min(band, this.pixelHeight - top);
            context.putImageData(new ImageData(this.pixels({ top, rows }), this.pixelWidth, rows), 0, top);
            if (progress?.((top + rows) / this.pixelHeight) === false)
                throw new PlumbagoError('stopped');
            await new Promise(resolve => setTimeout(resolve));
        }
    }

    /** Returns the path of the hand along stroke `index`: {kind, pressure, colour, width, closed, points: x, y in turn}; null past the last. */
    stroke(index) {
        const core = this.#core, at = core.web_new(48);
        if (!at || !this.#d)
            throw new PlumbagoError('out of memory, or the drawing is freed');
        try {
            if (!core.web_stroke(this.#d, index, at))
                return null;
            const [kind, pressure, colour, width, closed] = new Float64Array(core.memory.buffer, at, 5);
            const path = core.web_trace(this.#d, index, at, this.#o);
            if (!path)
                this.#fail();
            const n = new Uint32Array(core.memory.buffer, at, 1)[0];
            const points = new Float64Array(core.memory.buffer, path, 2 * n).slice();
            core.web_free(path);
            return { kind: ['line', 'hatch', 'letter', 'guide'][kind], pressure, colour, width, closed: !!closed, points };
        } finally {
            core.web_free(at);
        }
    }
}

// A colour as CSS writes it (#rgb, #rrggbb, or [r, g, b] from 0 to 1), as the list's words.
function colourWords(colour) {
    let rgb = colour;
    if (typeof colour === 'string') {
        const digits = /^#(?:[0-9a-f]{3}|[0-9a-f]{6})$/i.test(colour) ? colour.slice(1) : null;
        if (!digits)
            throw new PlumbagoError(`${colour}: a colour is #rgb, #rrggbb or [red, green, blue] from 0 to 1`);
        const step = digits.length / 3;
        rgb = [0, 1, 2].map(k => parseInt(digits.slice(k * step, k * step + step).padStart(2, digits[k * step]), 16) / 255);
    }
    return `colour ${rgb.map(number).join(' ')} 1`;
}

function number(value) {
    if (!Number.isFinite(value))
        throw new PlumbagoError(`${value} is not a number`);
    return String(value);
}

const words = (letter, ...values) => `${letter} ${values.map(number).join(' ')}`;

// A quarter of a circle as a Bézier curve: its handles are so long, times the radius.
const QUARTER = 4 / 3 * Math.tan(Math.PI / 8);

/**
 * A sheet collects shapes in mm, as rough.js' canvas does in pixels; draw() makes a Drawing of them. Each shape takes
 * {stroke: colour or null, width: mm, dash: [mm, …], fill: colour, hatch: degrees}; without `fill` an area stays empty. Calls can be chained.
 */
export class Sheet {
    #plumbago;
    #lines = [];

    constructor(plumbago, width, height) {
        this.#plumbago = plumbago;
        this.#lines.push('plumbago-list 1', words('page', width, height));
    }

    #add(path, { stroke = '#000', width = 0.35, dash = null, fill = null, hatch = null } = {}) {
        if (fill)
            this.#lines.push(`fill - ${colourWords(fill)} nonzero ${hatch === null ? '' : words('hatch', hatch) + ' '}${path}`);
        if (stroke)
            this.#lines.push(`stroke - ${colourWords(stroke)} ${words('width', width)} butt ${dash ? words('dash', ...dash) + ' @ 0 ' : ''}${path}`);
        return this;
    }

    line(x1, y1, x2, y2, style) {
        return this.#add(`${words('M', x1, y1)} ${words('L', x2, y2)}`, { ...style, fill: null });
    }

    /** Joins points, [[x, y], …], by straight lines. */
    linearPath(points, style) {
        return this.#add(points.map((p, i) => words(i ? 'L' : 'M', ...p)).join(' '), style);
    }

    polygon(points, style) {
        return this.#add(`${points.map((p, i) => words(i ? 'L' : 'M', ...p)).join(' ')} Z`, style);
    }

    rectangle(x, y, width, height, style) {
        return this.polygon([[x, y], [x + width, y], [x + width, y + height], [x, y + height]], style);
    }

    /** Draws about (x, y); as in rough.js, the sizes are diameters. */
    ellipse(x, y, width, height, style) {
        const a = width / 2, b = height / 2, c = a * QUARTER, d = b * QUARTER;
        return this.#add([words('M', x + a, y), words('C', x + a, y + d, x + c, y + b, x, y + b), words('C', x - c, y + b, x - a, y + d, x - a, y),
            words('C', x - a, y - d, x - c, y - b, x, y - b), words('C', x + c, y - b, x + a, y - d, x + a, y), 'Z'].join(' '), style);
    }

    circle(x, y, diameter, style) {
        return this.ellipse(x, y, diameter, diameter, style);
    }

    /** Draws from angle `start` to `stop`, radians, clockwise as seen; `closed` joins the ends to the centre. */
    arc(x, y, width, height, start, stop, closed = false, style = {}) {
        const a = width / 2, b = height / 2, n = Math.max(1, Math.ceil(Math.abs(stop - start) / (Math.PI / 2))), step = (stop - start) / n;
        const h = 4 / 3 * Math.tan(step / 4), parts = [words('M', x + a * Math.cos(start), y + b * Math.sin(start))];
        for (let i = 0; i < n; i++) {
            const u = start + i * step, v = u + step, [cu, su, cv, sv] = [Math.cos(u), Math.sin(u), Math.cos(v), Math.sin(v)];
            parts.push(words('C', x + a * (cu - h * su), y + b * (su + h * cu), x + a * (cv + h * sv), y + b * (sv - h * cv), x + a * cv, y + b * sv));
        }
        return this.#add(parts.join(' ') + (closed ? ` ${words('L', x, y)} Z` : ''), style);
    }

    /** Draws a smooth curve through points, [[x, y], …]: the tangent at each is parallel to the line between its neighbours. */
    curve(points, style) {
        const at = i => points[Math.min(Math.max(i, 0), points.length - 1)], parts = [words('M', ...points[0])];
        for (let i = 0; i + 1 < points.length; i++) {
            const [p, q, r, s] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
            parts.push(words('C', q[0] + (r[0] - p[0]) / 6, q[1] + (r[1] - p[1]) / 6, r[0] - (s[0] - q[0]) / 6, r[1] - (s[1] - q[1]) / 6, ...r));
        }
        return this.#add(parts.join(' '), style);
    }

    /** Returns the display list's text, plumbago-list(5). */
    toString() {
        return [...this.#lines, 'end', ''].join('\n');
    }

    /** Plans the shapes as pencil strokes; `settings` as in Plumbago.drawing(). The caller frees the result. */
    draw(settings) {
        return this.#plumbago.drawing(this.toString(), settings);
    }
}
