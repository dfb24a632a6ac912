#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Can a machine observer tell crops of drawn pages from crops of scanned ones?  observe_pages.py SCANS... -- DRAWN...

Each picture is cut into crops of 128 px (1.1 cm at 300 dpi), half overlapping; those with hardly any ink, and those black all over, are left out. A crop
becomes 24 numbers that do not know what is drawn: how grey is spread over the ink, how rough edges and cores are, how it correlates with itself some
pixels on, how its energy falls with frequency, how lines change along themselves. A linear discriminant learns to tell both kinds apart on all
pictures but one pair, and is asked about that pair, so that it never sees the page that it judges. Prints crops, error (the mean of both kinds' shares
of wrong answers; .5: it cannot tell, 0: it tells every time) and the numbers that tell most.
"""
import sys
import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter, distance_transform_edt

SIDE, STEP = 128, 64
NAMES = ('p1 p10 p50 p90 ink.sd ink.skew share core.sd flank.sd edge.width grad.mean grad.sd rough1 rough2 rough4 ac1 ac2 ac3 ac4 coherence '
         'width width.cv paper.sd slow').split()


def features(crop):
    """The numbers of one crop, or none where there is too little ink or paper."""
    paper = np.percentile(crop, 95)
    dark = np.clip(paper - crop, 0, None)
    soft = gaussian_filter(dark, 1.2)
    ink = soft > 0.25 * max(np.percentile(soft, 99), 1)
    share = ink.mean()
    if not .02 < share < .75 or np.percentile(soft, 99) < 15:
        return None
    d = dark[ink]
    inside = distance_transform_edt(ink)
    core, flank = inside >= 2, (inside > 0) & (inside < 2)
    gy, gx = np.gradient(gaussian_filter(dark, .7))
    g = np.hypot(gx, gy)[ink]
    rough = [np.abs(dark - gaussian_filter(dark, s))[ink].mean() / d.mean() for s in (1, 2, 4)]
    fine = dark - gaussian_filter(dark, 4)
    fine = np.where(core, fine, 0)
    power = (fine ** 2).sum() + 1e-9
    auto = [(fine[:, k:] * fine[:, :-k]).sum() / power / 2 + (fine[k:] * fine[:-k]).sum() / power / 2 for k in (1, 2, 3, 4)]
    jxx, jyy, jxy = (gaussian_filter(a, 3) for a in (gx * gx, gy * gy, gx * gy))
    coherence = (np.hypot(jxx - jyy, 2 * jxy) / (jxx + jyy + 1e-9))[ink].mean()
    ridge = inside[(inside >= 1) & (inside >= np.maximum.reduce([np.roll(inside, s, a) for s in (-1, 1) for a in (0, 1)]))]
    blank = crop[~(gaussian_filter(ink.astype(float), 3) > .02)]
    paper_sd = blank.std() if blank.size > 50 else 0
    slow = gaussian_filter(dark, 6)[core].std() / d.mean() if core.any() else 0
    top = np.percentile(d, 99) + 1e-9
    skew = ((d - d.mean()) ** 3).mean() / (d.std() + 1e-9) ** 3
    return [*(np.percentile(d, p) / top for p in (1, 10, 50, 90)), d.std() / d.mean(), skew, share, dark[core].std() / d.mean() if core.any() else 0,
            dark[flank].std() / d.mean(), flank.sum() / ink.sum(), g.mean() / d.mean(), g.std() / d.mean(), *rough, *auto, coherence,
            ridge.mean(), ridge.std() / ridge.mean(), min(paper_sd, 5), slow]


def crops_of(path):
    with Image.open(path) as picture:
        grey = np.asarray(picture.convert('L')).astype(float)
    rows = []
    for y in range(0, grey.shape[0] - SIDE + 1, STEP):
        for x in range(0, grey.shape[1] - SIDE + 1, STEP):
            f = features(grey[y:y + SIDE, x:x + SIDE])
            if f:
                rows.append(f)
    return np.array(rows).reshape(-1, len(NAMES))


def discriminant(a, b):
    """The direction and place between two kinds, each counted alike."""
    spread = (np.cov(a.T) + np.cov(b.T)) / 2 + .05 * np.eye(a.shape[1])
    w = np.linalg.solve(spread, b.mean(0) - a.mean(0))
    return w, w @ (a.mean(0) + b.mean(0)) / 2


def main():
    if '--' not in sys.argv:
        sys.exit(__doc__)
    cut = sys.argv.index('--')
    scanned, drawn = ([c for c in map(crops_of, files) if len(c)] for files in (sys.argv[1:cut], sys.argv[cut + 1:]))
    both = np.vstack(scanned + drawn)
    mean, sd = both.mean(0), both.std(0) + 1e-9
    scanned, drawn = ([(c - mean) / sd for c in kind] for kind in (scanned, drawn))
    wrong, n = np.zeros(2), np.zeros(2)
    for k in range(max(len(scanned), len(drawn))):
        i, j = k % len(scanned), k % len(drawn)
        w, place = discriminant(np.vstack(scanned[:i] + scanned[i + 1:]), np.vstack(drawn[:j] + drawn[j + 1:]))
        wrong += [(scanned[i] @ w > place).mean(), (drawn[j] @ w <= place).mean()]
        n += 1
    apart = np.abs(np.vstack(scanned).mean(0) - np.vstack(drawn).mean(0)) / np.sqrt((np.vstack(scanned).var(0) + np.vstack(drawn).var(0)) / 2 + 1e-9)
    telling = ', '.join(f'{NAMES[i]} {apart[i]:.1f}' for i in np.argsort(-apart)[:5])
    print(f'crops {sum(map(len, scanned))} {sum(map(len, drawn))} error {(wrong / n).mean():.3f} (scanned {wrong[0] / n[0]:.3f} drawn {wrong[1] / n[1]:.3f}) tell: {telling}')


if __name__ == '__main__':
    main()
