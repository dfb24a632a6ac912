// SPDX-License-Identifier: MIT
// Types of plumbago.js, which documents what each does. Lengths are millimetres on paper.

/** Settings of the command line by their long names: {pencil: '3B', seed: 7, dpi: 150, colour: true}. */
export type Settings = Record<string, string | number | boolean>;
/** #rgb, #rrggbb, or red, green and blue from 0 to 1. */
export type Colour = string | [number, number, number];
export type Point = [number, number];
export interface Style {
    stroke?: Colour | null;
    width?: number;
    dash?: number[] | null;
    fill?: Colour | null;
    hatch?: number | null;
}
export interface Stroke {
    kind: 'line' | 'hatch' | 'letter' | 'guide';
    pressure: number;
    colour: number;
    width: number;
    closed: boolean;
    points: Float64Array;
}
export type Progress = (done: number) => boolean | void;

export class PlumbagoError extends Error {}

export class Plumbago {
    static load(from?: { base?: string | URL; read?: (name: string) => Uint8Array | Promise<Uint8Array> }): Promise<Plumbago>;
    onmessage: ((level: number, text: string) => void) | null;
    readonly memoryBytes: number;
    pencil(grade: string): Promise<void>;
    sheet(width: number, height: number): Sheet;
    drawing(list: string | Uint8Array, settings?: Settings): Promise<Drawing>;
}

export class Drawing {
    readonly width: number;
    readonly height: number;
    readonly pixelWidth: number;
    readonly pixelHeight: number;
    readonly strokes: number;
    pixels(part?: { top?: number; rows?: number; progress?: Progress | null }): Uint8ClampedArray;
    drawOn(canvas: HTMLCanvasElement | OffscreenCanvas, how?: { band?: number; progress?: Progress | null }): Promise<void>;
    stroke(index: number): Stroke | null;
    free(): void;
}

export class Sheet {
    line(x1: number, y1: number, x2: number, y2: number, style?: Style): this;
    linearPath(points: Point[], style?: Style): this;
    polygon(points: Point[], style?: Style): this;
    rectangle(x: number, y: number, width: number, height: number, style?: Style): this;
    ellipse(x: number, y: number, width: number, height: number, style?: Style): this;
    circle(x: number, y: number, diameter: number, style?: Style): this;
    arc(x: number, y: number, width: number, height: number, start: number, stop: number, closed?: boolean, style?: Style): this;
    curve(points: Point[], style?: Style): this;
    toString(): string;
    draw(settings?: Settings): Promise<Drawing>;
}
