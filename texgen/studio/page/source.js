// SPDX-License-Identifier: Apache-2.0

// A source provides the pictures that the page shows: pictures drawn with the settings of the page,
// or the images of a baked set. A source has the members `size` (the size of the preset or of the
// baked images), `drafts` (true if the source can draw drafts), `largestWidth` (of its pictures) and
// `map` (the name of the map that it shows), and two functions:
//   picture(frame, width, quality, signal)
//     returns a picture: {pixels, width, height, frame, exact, low, high, map, transparent, draft}
//     `exact` is false for a draft, and while an automatic range of the map is provisional. It is always true for a
//     baked image.
//   pick(picture, x, y, signal)
//     returns the answer to /api/pick or /api/baked/pick for a pixel of a picture

import {page, post, postPicture} from "./api.js";

/**
 * Returns a source that draws the preset with the given settings. `transparent` is true if pictures
 * have pixels without foam.
 */
export function settingsSource(settings, {size, map, largestWidth, transparent}) {
    return {
        size,
        map,
        largestWidth,
        drafts: true,
        settings,
        async picture(frame, width, quality, signal) {
            const body = {settings, frame, map, width, quality, samples: "rgba"};
            return {...(await postPicture("/api/picture", body, signal)), map, transparent, draft: quality === "draft"};
        },
        pick(picture, x, y, signal) {
            const {frame, width} = picture;
            const body = {settings, page, frame, map, width, quality: "full", samples: "rgba", x, y};
            return post("/api/pick", body, signal);
        },
    };
}

/** Returns a source that reads the images of a baked set (an entry of /api/bakes). */
export function bakedSource(bake, map, largestWidth) {
    return {
        size: bake.size,
        map,
        largestWidth,
        drafts: false,
        settings: null,
        async picture(frame, width, quality, signal) {
            const body = {
                folder: bake.folder,
                set: bake.set,
                map,
                frame: bake.frames[frame - 1],
                width,
                samples: "rgba",
            };
            return {...(await postPicture("/api/baked", body, signal)), frame, map, exact: true, transparent: true};
        },
        pick(picture, x, y, signal) {
            const body = {
                folder: bake.folder,
                set: bake.set,
                map,
                frame: bake.frames[picture.frame - 1],
                x: (x + 0.5) / picture.width,
                y: (y + 0.5) / picture.height,
            };
            return post("/api/baked/pick", body, signal);
        },
    };
}
