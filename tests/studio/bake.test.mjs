// SPDX-License-Identifier: Apache-2.0
//
// Bakes, saved presets and downloads of the page.

import assert from "node:assert/strict";
import { readFile, readdir, stat } from "node:fs/promises";
import path from "node:path";
import test from "node:test";
import { open_studio, run, set_key, wait_for_exact_picture, with_studio } from "./studio.mjs";

async function fill_bake_form(page, folder, side) {
    await page.click("#bake-open");
    await page.fill("#bake-folder", folder);
    await page.fill("#bake-width", String(side));
    await page.fill("#bake-height", String(side));
}

async function start_bake(page, folder, side) {
    await fill_bake_form(page, folder, side);
    await page.click("#bake-start");
}

test("a bake writes a folder that verify accepts", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await set_key(page, "frames.count", 6);
        await set_key(page, "foam.bubbles", 50);
        await start_bake(page, "baked", 128);
        await page.locator("#bake-status").filter({ hasText: /complete|done|finished/i }).waitFor({ timeout: 60_000 });
        const files = await readdir(path.join(folder, "baked"));
        assert.equal(files.filter((file) => file.endsWith(".png")).length, 6);
        await run(["verify", path.join(folder, "baked")]);
        assert.deepEqual(errors, []);
    }));

test("the readout of a baked set has its numbers", () =>
    with_studio(async ({ folder, studio, browser }) => {
        await run(["bake", "pebbles", "--frames", "1-2", "--set", "frames.count=2", "--size", "128", "--maps", "height,id"], {
            cwd: folder,
        });
        const { page, errors } = await open_studio(browser, studio.url);
        await page.locator("#gallery-bakes").getByText("pebbles").click();
        await page.waitForFunction(() => window.studio.baked && window.studio.view.picture?.map === "height");
        if (await page.evaluate(() => window.studio.player.playing)) {
            await page.click("#play");
        }
        const box = await page.locator("#picture").boundingBox();
        await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
        await page.waitForFunction(() => /^\d/.test(document.getElementById("readout-value").textContent));
        assert.match(await page.locator("#readout-unit").textContent(), /diameter/);
        assert.deepEqual(errors, []);
    }));

test("each set of a folder can be shown", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const bake = ["bake", "pebbles", "--frames", "1", "--set", "frames.count=1", "--maps", "height"];
        await run([...bake, "--size", "128"], { cwd: folder });
        await run([...bake, "--size", "64", "--out", "out/{preset}_{map}.####.exr"], { cwd: folder });
        const { page, errors } = await open_studio(browser, studio.url);
        const entries = page.locator("#gallery-bakes button");
        for (const [index, width] of [128, 64].entries()) {
            await entries.nth(index).click();
            await page.waitForFunction((size) => window.studio.view.picture?.width === size, width);
            assert.equal(await page.locator("#gallery-bakes button[aria-current]").count(), 1);
        }
        assert.deepEqual(errors, []);
    }));

test("a bake can be canceled", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        await start_bake(page, "long", 4096);
        await page.locator("#bake-cancel").click();
        await page.locator("#bake-status").filter({ hasText: /canceled/i }).waitFor({ timeout: 60_000 });
        // Images that are complete stay, and none is half-written.
        // The bake makes the folder only when it writes its first frame.
        const files = await readdir(path.join(folder, "long")).catch(() => []);
        assert.ok(files.filter((file) => file.endsWith(".png")).length < 48);
        assert.deepEqual(files.filter((file) => file.endsWith(".part")), []);
    }));

test("a canceled bake is resumed after the page was loaded again", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await set_key(page, "foam.bubbles", 50);
        await start_bake(page, "resumed", 2048);
        const has_frames = () =>
            document.getElementById("bake-status").textContent.includes("frames") &&
            parseInt(document.getElementById("bake-numbers").textContent) > 1;
        await page.waitForFunction(has_frames, null, { timeout: 60_000 });
        await page.locator("#bake-cancel").click();
        await page.locator("#bake-status").filter({ hasText: /canceled/i }).waitFor({ timeout: 60_000 });
        const images = async () => (await readdir(path.join(folder, "resumed"))).filter((file) => file.endsWith(".png")).sort();
        const kept = await images();
        assert.ok(kept.length > 0 && kept.length < 48, `${kept.length} images`);
        const first = path.join(folder, "resumed", kept[0]);
        const written = (await stat(first)).mtimeMs;
        await page.reload();
        await wait_for_exact_picture(page);
        await fill_bake_form(page, "resumed", 2048);
        await page.check("#bake-resume");
        await page.click("#bake-start");
        await page.locator("#bake-status").filter({ hasText: /complete/i }).waitFor({ timeout: 60_000 });
        assert.equal((await images()).length, 48);
        assert.equal((await stat(first)).mtimeMs, written);
        await run(["verify", path.join(folder, "resumed")]);
        assert.deepEqual(errors, []);
    }));

test("a bake goes on while the page is loaded again", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page, errors } = await open_studio(browser, studio.url);
        await set_key(page, "foam.bubbles", 50);
        await start_bake(page, "reloaded", 512);
        await page.locator("#bake-progress").waitFor();
        await page.reload();
        await wait_for_exact_picture(page);
        await page.click("#bakes-refresh");
        const file = path.join(folder, "reloaded", "manifest.json");
        const is_complete = async () => {
            const text = await readFile(file, "utf8").catch(() => "{}");
            return JSON.parse(text).sets?.[0]?.files?.length === 48;
        };
        for (const end = Date.now() + 60_000; Date.now() < end && !(await is_complete()); ) {
            await page.waitForTimeout(200);
        }
        assert.ok(await is_complete(), "the bake has not ended after a minute");
        await run(["verify", path.join(folder, "reloaded")]);
        assert.deepEqual(errors, []);
    }));

test("the page saves presets that the program reads", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        await set_key(page, "foam.seed", 7);
        await page.click("#take-home");
        await page.click("#save-preset");
        await page.fill("#save-name", "mine");
        await page.locator("#save-form button[type=submit]").click();
        await page.locator("#gallery-files").getByText("mine").waitFor();
        assert.match(await readFile(path.join(folder, "mine.toml"), "utf8"), /extends = "sea_foam"/);
        await run(["bake", "mine.toml", "--frames", "1", "--size", "64"], { cwd: folder });
        const manifest = JSON.parse(await readFile(path.join(folder, "out", "manifest.json"), "utf8"));
        assert.match(manifest.sets[0].toml, /seed = 7/);
    }));

test("a frame can be downloaded as a drawing", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        await page.click("#take-home");
        const [download] = await Promise.all([page.waitForEvent("download"), page.click("#download-drawing")]);
        const file = path.join(folder, download.suggestedFilename());
        await download.saveAs(file);
        assert.match(await readFile(file, "utf8"), /<svg [^>]*width="100mm"/);
    }));

test("a frame can be downloaded", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        await set_key(page, "image.size", [64, 64]);
        await page.click("#take-home");
        const [download] = await Promise.all([page.waitForEvent("download"), page.click("#download-frame")]);
        const file = path.join(folder, download.suggestedFilename());
        await download.saveAs(file);
        assert.equal((await readFile(file)).subarray(1, 4).toString(), "PNG");
    }));
