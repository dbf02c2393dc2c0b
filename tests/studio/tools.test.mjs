// SPDX-License-Identifier: Apache-2.0
//
// The tools around the picture: sliders, comparison, variations, events and the readout.

import assert from "node:assert/strict";
import test from "node:test";
import { open_studio, set_key, stop_loop, version_of, wait_for_exact_picture, with_studio } from "./studio.mjs";

// Returns a hash of the left quarter of the picture's canvas, and the number of pictures shown so far. If a key is given,
// sets it right afterwards.
function left_side(page, key = null, value = null) {
    return page.evaluate(
        ([path, text]) => {
            const canvas = document.getElementById("picture");
            const version = Number(canvas.dataset.version);
            const { data } = canvas.getContext("2d").getImageData(0, 0, Math.floor(canvas.width / 4), canvas.height);
            if (path) {
                window.studio.state.set(path, text);
            }
            const hash = data.reduce((sum, sample) => (sum * 31 + sample) % 4294967291, 0);
            return { hash, version };
        },
        [key, value],
    );
}

test("a slider that is dragged changes the picture, and is one edit", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await stop_loop(page);
        await page.fill("#form-search", "albedo.film_width");
        const slider = page.locator('[data-slider="albedo.film_width"]');
        const value = () => page.locator('#form [data-key="albedo.film_width"]').inputValue();
        const original = await value();
        const before = await left_side(page);
        const box = await slider.boundingBox();
        const y = box.y + box.height / 2;
        await page.mouse.move(box.x + 0.2 * box.width, y);
        await page.mouse.down();
        for (const part of [0.4, 0.6, 0.8]) {
            await page.mouse.move(box.x + part * box.width, y, { steps: 5 });
            await page.waitForTimeout(50);
        }
        const held = await value();
        await page.mouse.up();
        await wait_for_exact_picture(page, before.version);
        assert.notEqual((await left_side(page)).hash, before.hash);
        assert.notEqual(held, original);
        assert.equal(await value(), held);
        await page.click("#undo");
        await page.waitForFunction(
            (text) => document.querySelector('#form [data-key="albedo.film_width"]').value === text,
            original,
        );
        assert.deepEqual(errors, []);
    }));

test("the comparison shows the picture before the last change", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await stop_loop(page);
        await set_key(page, "relief.strength", 0.1);
        // While the range of this map is provisional, its pictures are not exact.
        await page.selectOption("#map", "height");
        await page.waitForFunction(() => window.studio.view.picture?.map === "height");
        await page.click("#compare");
        await page.press("#split", "Home"); // shows the current picture alone
        const before = await left_side(page, "relief.width", "0.1");
        await wait_for_exact_picture(page, before.version);
        assert.notEqual((await left_side(page)).hash, before.hash);
        assert.equal(await page.textContent("#compare-left"), "Before the last change");
        await page.press("#split", "End"); // shows the earlier picture alone
        assert.equal((await left_side(page)).hash, before.hash);
        assert.deepEqual(errors, []);
    }));

test("the comparison counts changes whose pictures were not shown", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await stop_loop(page);
        await page.click("#compare");
        await page.evaluate(() => {
            window.studio.state.set("relief.width", "0.1");
            window.studio.state.set("relief.strength", "0.2");
        });
        assert.equal(await page.textContent("#compare-left"), "Before the last 2 changes");
        await page.click("#compare-keep");
        assert.equal(await page.textContent("#compare-left"), "Kept picture");
        assert.deepEqual(errors, []);
    }));

test("a variation that is clicked becomes the preset", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await page.click("#tab-variations");
        await page.selectOption("#vary-key", "foam.bubbles");
        await page.fill("#vary-from", "40");
        await page.fill("#vary-to", "160");
        await page.locator("#vary-to").press("Enter");
        const cells = page.locator("#sheet .cell");
        await page.waitForFunction(() => {
            const all = [...document.querySelectorAll("#sheet .cell")];
            return all.length > 2 && all[0].dataset.value === "40" && all.every((cell) => cell.classList.contains("drawn"));
        });
        const value = await cells.nth(1).getAttribute("data-value");
        await cells.nth(1).click();
        await page.waitForFunction(
            (bubbles) => document.querySelector('#form [data-key="foam.bubbles"]').value === bubbles,
            value,
        );
        assert.ok(await page.locator("#panel-picture").isVisible());
        assert.deepEqual(errors, []);
    }));

test("an event can be added only to a loop that allows events", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await page.click("#event-add");
        assert.match(await page.textContent("#message"), /loop.kind = "none" or "pingpong", not "breathe"/);
        assert.equal(await page.locator("#events .event").count(), 0);
        await set_key(page, "foam.bubbles", 60);
        await set_key(page, "frames.count", 12);
        await set_key(page, "loop.kind", "none");
        const version = await version_of(page);
        await page.click("#event-add");
        await page.locator("#events .event").waitFor();
        await wait_for_exact_picture(page, version);
        assert.ok(await page.locator("#event-editor").isVisible());
        assert.ok(await page.locator("#event-error").isHidden());
        await page.click("#event-delete");
        assert.equal(await page.locator("#events .event").count(), 0);
        assert.deepEqual(errors, []);
    }));

// The expected frames are those of tests/texgen/preset/event_frames_test.cpp.
test("an event with times lasts for the frames in which the program makes it", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        const frames_of = (time, values) =>
            page.evaluate(
                async ([text, keys]) => {
                    const { rangeOf } = await import("./event_model.js");
                    return rangeOf({ time: text }, keys);
                },
                [time, values],
            );
        const tenths = { "frames.time_step": 0.1 };
        assert.deepEqual(await frames_of("0.3", tenths), [4, 4]);
        assert.deepEqual(await frames_of("[0.0, 0.3]", tenths), [2, 4]);
        assert.deepEqual(await frames_of("[0.3, 0.5]", tenths), [5, 6]);
        const growing = { "frames.time_step": 1, "frames.warm_up": 10, "frames.step_growth": 2 };
        assert.deepEqual(await frames_of("5.0", growing), [2, 2]);
        assert.deepEqual(await frames_of("[11.0, 17.0]", growing), [3, 4]);
        assert.deepEqual(await frames_of("18.0", growing), [5, 5]);
        assert.deepEqual(errors, []);
    }));

test("the readout gives the bubble below the pointer", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await stop_loop(page);
        const box = await page.locator("#picture").boundingBox();
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        await page.waitForFunction(() => /area/.test(document.getElementById("readout-bubble").textContent));
        assert.match(await page.textContent("#readout-position"), /^\d+, \d+$/);
        assert.match(await page.textContent("#readout-value"), /^#[0-9a-f]{6}/);
        assert.deepEqual(errors, []);
    }));
