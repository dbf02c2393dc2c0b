// SPDX-License-Identifier: Apache-2.0
//
// The lit surface, the themes, and accessibility. With FOAM_SCREENSHOTS=FOLDER, also writes screenshots to look at.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import test from "node:test";
import { package_folder } from "../browser/packages.mjs";
import { open_studio, with_studio } from "./studio.mjs";

const widths = [1024, 1440, 2560];

async function screenshot(page, name) {
    if (process.env.FOAM_SCREENSHOTS) {
        await page.screenshot({ path: path.join(process.env.FOAM_SCREENSHOTS, `${name}.png`) });
    }
}

// Returns the number of different colors in a screenshot of the surface, and a checksum of its pixels.
async function surface_colors(page) {
    const png = await page.locator("#surface").screenshot();
    return page.evaluate(async (base64) => {
        const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes]));
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
        return { colors: new Set(pixels).size, sum: pixels.reduce((sum, pixel) => (sum * 31 + pixel) % 4294967291, 0) };
    }, png.toString("base64"));
}

test("the surface is drawn and changes with the light", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await page.click("#tab-lit");
        await page.waitForFunction(() => Number(document.getElementById("surface").dataset.version) > 0, null,
            { timeout: 60_000 });
        await page.waitForTimeout(500);
        const first = await surface_colors(page);
        assert.ok(first.colors > 1000, `${first.colors} colors`);
        await page.locator("#lit-azimuth").fill("300");
        await page.waitForTimeout(1000);
        const second = await surface_colors(page);
        assert.ok(second.colors > 1000, `${second.colors} colors`);
        assert.notEqual(second.sum, first.sum);
        await screenshot(page, "surface");
        assert.deepEqual(errors, []);
    }));

test("the surface plays the loop", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await page.evaluate(() => {
            window.studio.state.set("foam.bubbles", "60");
            window.studio.state.set("frames.count", "6");
        });
        const version = () => page.evaluate(() => Number(document.getElementById("surface").dataset.version ?? 0));
        await page.click("#tab-lit");
        await page.waitForFunction(() => Number(document.getElementById("surface").dataset.version) > 0, null,
            { timeout: 60_000 });
        await page.waitForFunction(() => document.getElementById("loaded").textContent.includes("in memory"), null,
            { timeout: 60_000 });
        const before = await version();
        if (!(await page.evaluate(() => window.studio.player.playing))) {
            await page.click("#play");
        }
        // All six frames are shown, and some of them twice.
        await page.waitForFunction((least) => Number(document.getElementById("surface").dataset.version) > least, before + 12,
            { timeout: 60_000 });
        await page.click("#play");
        await page.waitForFunction((least) => Number(document.getElementById("surface").dataset.version) > least, await version(),
            { timeout: 60_000 });
        await page.waitForTimeout(500);
        const first = await surface_colors(page);
        await page.evaluate(() => window.studio.player.step(3));
        await page.waitForTimeout(2500);
        assert.notEqual((await surface_colors(page)).sum, first.sum);
        assert.deepEqual(errors, []);
    }));

for (const colorScheme of ["dark", "light"]) {
    test(`axe-core finds nothing in the ${colorScheme} theme`, () =>
        with_studio(async ({ studio, browser }) => {
            const { page } = await open_studio(browser, studio.url, { colorScheme });
            const axe = await readFile(path.join(package_folder("studio", "axe-core"), "axe.min.js"), "utf8");
            await page.focus('#form [data-key="foam.bubbles"]'); // shows the help of the key
            for (const opener of [null, "#tab-lit", "#tab-variations", "#bake-open"]) {
                if (opener) {
                    await page.click(opener);
                    await page.waitForTimeout(500);
                }
                await page.evaluate(axe);
                const { violations } = await page.evaluate(() => window.axe.run());
                const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
                assert.deepEqual(found, [], `after ${opener}`);
            }
        }));

    for (const width of widths) {
        test(`the page fits a window of ${width} pixels in the ${colorScheme} theme`, () =>
            with_studio(async ({ studio, browser }) => {
                const { page } = await open_studio(browser, studio.url, { width, height: Math.round(width * 0.625), colorScheme });
                const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
                assert.ok(overflow <= 0, `${overflow} pixels too wide`);
                await page.waitForTimeout(2000);
                await screenshot(page, `${colorScheme}_${width}`);
            }));
    }
}
