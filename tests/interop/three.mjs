// SPDX-License-Identifier: Apache-2.0
//
// Draws KTX2 textures of foamtex in Chromium with three.js, and compares the pixels with PNGs of the same frames. See
// three.sh.

import assert from "node:assert/strict";
import { launch_chromium, open_page, serve } from "../browser/chromium.mjs";
import { package_folder, root } from "../browser/packages.mjs";

const imports = {
    three: "/three/build/three.module.js",
    "three/addons/": "/three/examples/jsm/",
    "ktx-parse": "/ktx-parse/dist/index.mjs",
    fzstd: "/fzstd/esm/index.mjs",
};
const html = `<!doctype html><link rel="icon" href="data:,"><script type="importmap">${JSON.stringify({ imports })}</script>
<script type="module">globalThis.textures = await import("/interop/three_page.mjs");</script>`;

async function open_three(browser, scratch) {
    const opened = await open_page(browser);
    await serve(opened.page, {
        documents: { "/index.html": html },
        folders: {
            "/three/": package_folder("interop", "three"),
            "/ktx-parse/": package_folder("interop", "ktx-parse"),
            "/fzstd/": package_folder("interop", "fzstd"),
            "/interop/": `${root}/tests/interop`,
            "/files/": scratch,
        },
    });
    await opened.page.goto("http://test.invalid/index.html");
    await opened.page.waitForFunction(() => globalThis.textures !== undefined);
    return opened;
}

const to_light = (code) => (code <= 10.31475 ? code / 3294.6 : ((code / 255 + 0.055) / 1.055) ** 2.4);
const to_code = (light) => 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);

// Returns the mean of four pixels as a mip level stores it: of light, weighted by alpha, for colors, and of unit vectors for
// normals.
function mean_of(pixels, meaning) {
    const alphas = pixels.map((pixel) => pixel[3]);
    const weights = meaning === "color" && Math.max(...alphas) > 0 ? alphas : alphas.map(() => 1);
    const mean = (values, by) => values.reduce((sum, value, k) => sum + by[k] * value, 0) / by.reduce((sum, x) => sum + x, 0);
    const means = (convert) => [0, 1, 2].map((channel) => mean(pixels.map((pixel) => convert(pixel[channel])), weights));
    const alpha = mean(alphas, [1, 1, 1, 1]);
    if (meaning === "color") {
        return [...means(to_light).map(to_code), alpha];
    }
    if (meaning === "normal") {
        const vector = means((code) => code / 127.5 - 1);
        return [...vector.map((x) => (x / Math.hypot(...vector) + 1) * 127.5), alpha];
    }
    return [...means((code) => code), alpha];
}

// Returns the pixels of mip level 1 of a picture.
function half_size({ width, pixels }, meaning) {
    const at = (x, y) => pixels.slice(4 * (y * width + x), 4 * (y * width + x) + 4);
    const half = [];
    for (let y = 0; y < pixels.length / 4 / width; y += 2) {
        for (let x = 0; x < width; x += 2) {
            half.push(...mean_of([at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)], meaning));
        }
    }
    return { width: width / 2, pixels: half };
}

// Returns the PSNR of the first channels in decibels.
function psnr(drawn, expected, channels) {
    assert.equal(drawn.length, expected.length);
    const errors = drawn.map((code, k) => (k % 4 < channels ? (code - expected[k]) ** 2 : 0));
    const mean = errors.reduce((sum, error) => sum + error, 0) / ((channels * drawn.length) / 4);
    return 10 * Math.log10(255 ** 2 / mean);
}

function check(name, drawn, expected, { channels, smallest }) {
    const reds = drawn.filter((_, k) => k % 4 === 0);
    assert.ok(Math.max(...reds) - Math.min(...reds) > 20, `${name}: the drawing is uniform`);
    const found = psnr(drawn, expected.pixels, channels);
    assert.ok(found >= smallest, `${name}: the PSNR is ${found.toFixed(1)} dB, below ${smallest} dB`);
    console.log(`${name}: ${found.toFixed(1)} dB`);
}

// The channels that a texture stores, and the smallest PSNR in decibels that block compression may give. The values are
// about 1 dB below those of the encoder. The images are small, and their details are smaller than a block.
const maps = {
    albedo: { meaning: "color", channels: 3, smallest: 33, format: "BC7 sRGB" },
    ORM: { meaning: "data", channels: 3, smallest: 37, format: "BC7" },
    normal: { meaning: "normal", channels: 2, smallest: 32, format: "BC5" },
    roughness: { meaning: "data", channels: 1, smallest: 40, format: "BC4" },
};
// Without block compression, codes are rounded: errors that are distributed evenly from -0.5 to 0.5 codes give 58.9 dB.
const rounded = 58;
// The browser reduces the 16 bits of a PNG to 8. Half of the codes may differ by 1, which gives 51.1 dB.
const reduced = 51;

const scratch = process.argv[2];
const frames = ["0001", "0033", "0065"];
const browser = await launch_chromium();
try {
    const { page, errors } = await open_three(browser, scratch);
    const call = (name, ...args) =>
        page.evaluate(([function_name, given]) => globalThis.textures[function_name](...given), [name, args]);
    const png_of = (name) => call("png_pixels", `/files/png/${name}.png`);

    // Checks the mip levels 0 and 1 that draw(level) returns.
    async function check_levels(title, draw, png, facts) {
        for (const [level, expected] of [png, half_size(png, facts.meaning)].entries()) {
            check(`${title}, level ${level}`, await draw(level), expected, facts);
        }
    }

    async function check_array(map, facts) {
        const array = `/files/array/lava_array_${map}.ktx2`;
        for (const [layer, frame] of frames.entries()) {
            const draw = (level) => call("draw_layer", array, layer, level);
            await check_levels(`array of ${map}, ${facts.format}, layer ${layer}`, draw, await png_of(`${map}.${frame}`), facts);
        }
        // The limitations of the loaders that README.md states.
        assert.equal(await call("loader_verdict", array), "single");
        assert.equal(await call("dds_loader_reads", `/files/dds/${map}.0033.dds`), false);
    }

    async function check_single(name, facts) {
        const png = await png_of(name);
        const draw = (folder) => (level) => call("draw_single", `/files/${folder}/${name}.ktx2`, level);
        await check_levels(`KTX2Loader, ${name}, ${facts.format}`, draw("ktx2"), png, facts);
        await check_levels(`KTX2Loader, ${name} without blocks`, draw("plain_ktx2"), png, { ...facts, smallest: rounded });
    }

    console.log(await call("renderer_name"));
    for (const [map, facts] of Object.entries(maps)) {
        await check_array(map, facts);
        await check_single(`${map}.0033`, facts);
    }
    await check_single("transparent", { ...maps.albedo, channels: 4, smallest: 28 });
    for (const [layer, frame] of frames.entries()) {
        const drawn = await call("draw_layer_of_integers", "/files/array/lava_array_height.ktx2", layer);
        const facts = { channels: 1, smallest: reduced };
        check(`array of height, R16, layer ${layer}`, drawn, await png_of(`height.${frame}`), facts);
    }
    assert.match(await call("loader_verdict", "/files/ktx2/height.0033.ktx2"), /Unsupported vkFormat: 70/);
    const unexpected = errors.filter((error) => !error.startsWith("THREE.DDSLoader.parse: Unsupported DXGI_FORMAT code"));
    assert.deepEqual(unexpected, []);
} finally {
    await browser.close();
}
