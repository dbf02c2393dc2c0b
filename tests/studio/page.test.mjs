// SPDX-License-Identifier: Apache-2.0
//
// The page shows the pixels that a bake writes, and follows the form.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import path from "node:path";
import test from "node:test";
import { promisify } from "node:util";
import {
    decoded_png,
    open_studio,
    program,
    run,
    set_key,
    shown_pixels,
    stop_loop,
    type_key,
    version_of,
    wait_for_exact_picture,
    with_studio,
} from "./studio.mjs";

const shell = promisify(execFile);
const side = 256;

// Returns the command that the page copies.
async function copied_command(page) {
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await page.click("#take-home");
    await page.click("#copy-command");
    return page.evaluate(() => navigator.clipboard.readText());
}

// Runs a command that bakes a map of frame 1 in a folder. Returns the content of its image.
async function baked_image(command, folder, map) {
    const line = `${command} --frames 1 --maps ${map} --out copied.png -q`.replace("foamtex", `'${program}'`);
    await shell("sh", ["-c", line], { cwd: folder });
    return readFile(path.join(folder, "copied.png"));
}

test("a slider changes the pixels, which equal those of the copied command", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await stop_loop(page);
        await set_key(page, "image.size", [side, side]);
        const before = await shown_pixels(page, side, side);
        await set_key(page, "relief.width", 0.2);
        await set_key(page, "foam.bubbles", 100);
        const after = await shown_pixels(page, side, side);
        assert.notDeepEqual(after, before);
        const command = await copied_command(page);
        assert.match(command, /foamtex bake sea_foam .*--set foam.bubbles=100/);
        const baked = await decoded_png(page, await baked_image(command, folder, "lit"));
        assert.deepEqual(after, baked);
        assert.deepEqual(errors, []);
    }));

// The page has 8 bits per sample, and the browser rounds the 16 bits of the baked image.
test("a map with an automatic range has the pixels of a bake as soon as its loop is loaded", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await stop_loop(page);
        await set_key(page, "image.size", [side, side]);
        await set_key(page, "foam.bubbles", 60);
        await set_key(page, "frames.count", 6);
        await page.selectOption("#map", "height");
        await page.waitForFunction(() => window.studio.view.picture?.map === "height");
        await wait_for_exact_picture(page);
        const shown = await shown_pixels(page, side, side);
        const baked = await decoded_png(page, await baked_image(await copied_command(page), folder, "height"));
        assert.equal(shown.length, baked.length);
        const largest = shown.reduce((most, sample, k) => Math.max(most, Math.abs(sample - baked[k])), 0);
        assert.ok(largest <= 1, `a sample differs by ${largest}`);
        assert.ok(new Set(shown).size > 100, "the picture is uniform");
        assert.deepEqual(errors, []);
    }));

test("every preset opens", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        const presets = JSON.parse(await run(["presets", "list", "--json"])).presets;
        const cards = page.locator("#gallery-presets button");
        assert.equal(await cards.count(), presets.length);
        for (const [index, preset] of presets.entries()) {
            const version = await version_of(page);
            await cards.nth(index).click();
            await page.waitForFunction(
                ([name, shown]) =>
                    document.getElementById("document-name").textContent.replaceAll(" ", "_") === name &&
                    Number(document.getElementById("picture").dataset.version) > shown,
                [preset.name, index === 0 ? version - 1 : version],
                { timeout: 30_000 },
            );
        }
        assert.deepEqual(errors, []);
    }));

test("every key has a control, and a wrong value shows the message of the program", () =>
    with_studio(async ({ studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        const schema = JSON.parse(await run(["presets", "keys", "--json-schema"]));
        const keys = Object.entries(schema.properties).flatMap(([table, { properties }]) =>
            Object.keys(properties ?? {}).map((name) => `${table}.${name}`));
        assert.ok(keys.length > 100);
        const shown = await page.evaluate(() =>
            [...document.querySelectorAll("#form [data-key]")].map((element) => element.dataset.key));
        assert.deepEqual(keys.filter((key) => !shown.includes(key)), []);
        await type_key(page, "foam.bubbles", 2);
        const row = page.locator('#form [data-row="foam.bubbles"]');
        await row.locator(".message").filter({ hasText: "must be an integer from 4 to 1000000" }).waitFor();
        await set_key(page, "foam.bubbles", 50);
        assert.equal(await row.locator(".message").isVisible(), false);
    }));

test("a loop plays from memory", () =>
    with_studio(async ({ studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await set_key(page, "frames.count", 12);
        await set_key(page, "foam.bubbles", 60);
        await page.waitForFunction(() => document.getElementById("loaded").textContent.includes("in memory"), null,
            { timeout: 60_000 });
        // Frames are shown without a request. Requests for thumbnails of the gallery, 160 pixels wide, go on.
        let requests = 0;
        page.on("request", (request) => {
            const is_picture = request.url().endsWith("/api/picture") && request.postDataJSON().width !== 160;
            requests += is_picture ? 1 : 0;
        });
        const frames = new Set();
        const end = Date.now() + 20_000;
        while (frames.size < 12 && Date.now() < end) {
            frames.add(await page.evaluate(() => document.getElementById("picture").dataset.frame));
            await page.waitForTimeout(10);
        }
        assert.equal(frames.size, 12);
        assert.equal(requests, 0);
        assert.deepEqual(errors, []);
    }));

test("edits can be undone and are kept when the page is loaded again", () =>
    with_studio(async ({ studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        const bubbles = () => page.locator('#form [data-key="foam.bubbles"]').inputValue();
        const original = await bubbles();
        await set_key(page, "foam.bubbles", 77);
        await page.reload();
        await wait_for_exact_picture(page);
        assert.equal(await bubbles(), "77");
        await set_key(page, "foam.bubbles", 78);
        for (const expected of ["77", original]) {
            await page.click("#undo");
            await page.waitForFunction((value) => document.querySelector('#form [data-key="foam.bubbles"]').value === value, expected);
        }
    }));
