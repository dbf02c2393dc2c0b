// SPDX-License-Identifier: Apache-2.0
//
// Measures in Chromium how quickly the page of the studio follows its user: 600 bubbles, pictures of 512 x 512 pixels. Prints
// a table. Run by studio_latency.

import { mkdtemp, rm } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import { launch_chromium, open_page } from "../browser/chromium.mjs";
import { start_studio, wait_for_exact_picture } from "../studio/studio.mjs";

const presets = (process.env.PRESETS ?? "sea_foam,pebbles,stained_glass,lava").split(",");
const edits = Number(process.env.EDITS ?? 40);

function quantile(numbers, fraction) {
    const sorted = [...numbers].sort((a, b) => a - b);
    return sorted[Math.min(sorted.length - 1, Math.floor(fraction * sorted.length))];
}

// Moves the slider of a key in `count` steps, as a user drags it, and measures each time from the input event to the next
// picture on the canvas. Returns the times in milliseconds.
function drag(page, key, count) {
    return page.evaluate(
        async ([key_, count_]) => {
            const slider = document.querySelector(`#form [data-slider="${key_}"]`);
            const picture = document.getElementById("picture");
            const times = [];
            slider.dispatchEvent(new PointerEvent("pointerdown"));
            for (let k = 0; k < count_; ++k) {
                const changed = new Promise((resolve) => {
                    const observer = new MutationObserver(() => {
                        observer.disconnect();
                        requestAnimationFrame(() => resolve());
                    });
                    observer.observe(picture, { attributes: true, attributeFilter: ["data-version"] });
                });
                const range = Number(slider.max) - Number(slider.min);
                slider.value = Number(slider.min) + range * (0.3 + 0.4 * ((k + 1) / count_));
                const start = performance.now();
                slider.dispatchEvent(new Event("input", { bubbles: true }));
                await changed;
                times.push(performance.now() - start);
                await new Promise((resolve) => setTimeout(resolve, 60));
            }
            slider.dispatchEvent(new PointerEvent("pointerup"));
            slider.dispatchEvent(new Event("change", { bubbles: true }));
            return times;
        },
        [key, count],
    );
}

async function loop_time(page) {
    const start = Date.now();
    await page.waitForFunction(() => document.getElementById("loaded").textContent.includes("in memory"), null, {
        timeout: 120_000,
        polling: 20,
    });
    return (Date.now() - start) / 1000;
}

// Plays for two seconds. Returns the number of frames that were skipped and shown.
function played(page) {
    return page.evaluate(async () => {
        const picture = document.getElementById("picture");
        const count = Number(document.getElementById("scrub").max);
        const frames = [];
        const observer = new MutationObserver(() => frames.push(Number(picture.dataset.frame)));
        observer.observe(picture, { attributes: true, attributeFilter: ["data-version"] });
        await new Promise((resolve) => setTimeout(resolve, 2000));
        observer.disconnect();
        let skipped = 0;
        for (let k = 1; k < frames.length; ++k) {
            skipped += (frames[k] - frames[k - 1] + count) % count - 1;
        }
        return { shown: frames.length, skipped };
    });
}

async function measure(browser, preset) {
    const folder = await mkdtemp(path.join(os.tmpdir(), "foamtex-studio-"));
    const begin = Date.now();
    const studio = await start_studio(folder);
    const { page } = await open_page(browser);
    try {
        await page.setViewportSize({ width: 1440, height: 900 });
        await page.goto(studio.url);
        await page.waitForFunction(() => Number(document.getElementById("picture").dataset.version) > 0, null, { polling: 5 });
        const first = Date.now() - begin;
        await wait_for_exact_picture(page);
        await page.evaluate((name) => window.studio.open(name), preset);
        await page.evaluate(() => {
            window.studio.ui.set("width", 512);
            window.studio.state.set("foam.bubbles", "600");
            window.studio.state.set("frames.count", "48");
            window.studio.state.set("output.frames_per_second", "60");
        });
        await page.waitForTimeout(100);
        await loop_time(page);
        await page.click("#play");
        const looks = await drag(page, "relief.width", edits);
        await page.waitForTimeout(500);
        const foams = await drag(page, "foam.area_ratio", edits);
        await page.waitForTimeout(200);
        const loop = await loop_time(page);
        await page.click("#play");
        const frames = await played(page);
        return [preset, first, quantile(looks, 0.5), quantile(looks, 0.95), quantile(foams, 0.5), quantile(foams, 0.95), loop,
            frames.shown, frames.skipped];
    } finally {
        await studio.stop();
        await page.context().close();
        await rm(folder, { recursive: true });
    }
}

// Without a GPU, Chromium draws pages with the processor. The GPU that launch_chromium emulates for WebGL draws them several
// times more slowly, and no user has it.
const browser = await launch_chromium({ args: ["--disable-gpu"] });
console.log("| preset | first picture (ms) | look key, median (ms) | 95 % | foam key, median (ms) | 95 % | loop of 48 frames (s) | shown in 2 s | skipped |");
console.log("|---|---|---|---|---|---|---|---|---|");
for (const preset of presets) {
    const row = await measure(browser, preset);
    console.log(`| ${row.map((value) => (typeof value === "number" && !Number.isInteger(value) ? value.toFixed(1) : value)).join(" | ")} |`);
}
await browser.close();
