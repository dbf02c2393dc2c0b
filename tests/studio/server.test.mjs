// SPDX-License-Identifier: Apache-2.0
//
// Who may use a studio, several pages at once, and a studio that ends.

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import test from "node:test";
import { open_page } from "../browser/chromium.mjs";
import { open_session, open_studio, set_key, start_studio, with_studio } from "./studio.mjs";

test("a page without the token gets nothing", () =>
    with_studio(async ({ studio, browser }) => {
        const { page } = await open_page(browser);
        await page.goto(`http://localhost:${studio.port}/`);
        await page.locator("#banner").filter({ hasText: "address" }).waitFor();
        const status = await page.evaluate(async () => (await fetch("/api/program")).status);
        assert.equal(status, 403);
    }));

test("a page of another site can neither read nor change anything", () =>
    with_studio(async ({ studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        const other = await page.context().newPage();
        await other.route("http://other.invalid/", (route) => route.fulfill({ body: "<title>Other</title>", contentType: "text/html" }));
        await other.goto("http://other.invalid/");
        const results = await other.evaluate(async (port) => {
            const attempt = async (target, options) => {
                try {
                    return (await fetch(`http://localhost:${port}${target}`, options)).status;
                } catch (error) {
                    return error.name;
                }
            };
            const json = { "Content-Type": "application/json" };
            return [
                await attempt("/api/program", { credentials: "include" }),
                await attempt("/api/bakes", { method: "POST", headers: json, body: "{}", credentials: "include" }),
            ];
        }, studio.port);
        assert.deepEqual(results, ["TypeError", "TypeError"]);
        const framed = await other.evaluate(async (port) => {
            const frame = document.createElement("iframe");
            frame.src = `http://localhost:${port}/`;
            document.body.append(frame);
            await new Promise((resolve) => frame.addEventListener("load", resolve));
            try {
                return frame.contentDocument !== null;
            } catch {
                return false;
            }
        }, studio.port);
        assert.equal(framed, false);
    }));

test("the address can be used once", () =>
    with_studio(async ({ studio, browser }) => {
        await open_studio(browser, studio.url);
        const { page } = await open_page(browser);
        await page.goto(studio.url);
        await page.locator("#banner").filter({ hasText: "address" }).waitFor();
    }));

test("two pages work at the same time", () =>
    with_studio(async ({ studio, browser }) => {
        const { page: first } = await open_studio(browser, studio.url);
        const second = await first.context().newPage();
        await second.goto(`http://localhost:${studio.port}/`);
        await second.waitForFunction(() => document.getElementById("picture").dataset.exact === "true");
        await Promise.all([set_key(first, "foam.seed", 5), set_key(second, "foam.seed", 6)]);
        const seed = (page) => page.locator('#form [data-key="foam.seed"]').inputValue();
        assert.equal(await seed(first), "5");
        assert.equal(await seed(second), "6");
    }));

test("the page says that the studio has ended, and comes back", () =>
    with_studio(async ({ folder, studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        assert.equal(await studio.stop(), 0);
        await page.locator("#banner").filter({ hasText: "foamtex studio" }).waitFor({ timeout: 30_000 });
        const again = await start_studio(folder, ["--port", String(studio.port)]);
        try {
            // The user opens the address that the new studio has printed, in the same browser.
            const opened = await page.context().newPage();
            await opened.goto(again.url);
            await page.locator("#banner").waitFor({ state: "hidden", timeout: 30_000 });
            await set_key(page, "foam.seed", 9);
        } finally {
            await again.stop();
        }
    }));

test("the studio ends while a picture is awaited", () =>
    with_studio(async ({ studio, browser }) => {
        const { page } = await open_studio(browser, studio.url);
        await page.evaluate(() => {
            const body = JSON.stringify({
                settings: { preset: "fizz", set: [], events: null }, page: "x", frame: 1, map: "lit", width: 64, quality: "full",
            });
            fetch("/api/picture", { method: "POST", headers: { "Content-Type": "application/json" }, body }).catch(() => {});
        });
        assert.equal(await studio.stop(), 0);
    }));

// Returns the memory that a process has in use, in MB.
async function memory_of(pid) {
    const status = await readFile(`/proc/${pid}/status`, "utf8");
    return Number(/VmRSS:\s+(\d+) kB/.exec(status)[1]) / 1024;
}

test("memory stays flat while 10,000 pictures are drawn", async () => {
    const folder = await mkdtemp(path.join(os.tmpdir(), "foamtex-studio-"));
    const studio = await start_studio(folder);
    try {
        const post = await open_session(studio);
        const maps = ["lit", "albedo", "normal", "height", "id_color"];
        const draw = (k) =>
            post("/api/picture", {
                settings: {
                    preset: "sea_foam",
                    set: ["foam.bubbles=40", "frames.count=8", `relief.width=${0.1 + (k % 97) / 500}`],
                    events: null,
                },
                page: "draws",
                frame: 1 + (k % 8),
                map: maps[k % maps.length],
                width: 64 + (k % 13),
                quality: "full",
                samples: "rgba",
            });
        let next = 0;
        const draw_until = (end) =>
            Promise.all(
                Array.from({ length: 4 }, async () => {
                    while (next < end) {
                        await draw(next++);
                    }
                }),
            );
        // The cache of recent frames is full after the first draws.
        await draw_until(3000);
        const before = await memory_of(studio.pid);
        await draw_until(10_000);
        const after = await memory_of(studio.pid);
        assert.ok(after < before + 16, `${before.toFixed(1)} MB before, ${after.toFixed(1)} MB after`);
    } finally {
        await studio.stop();
        await rm(folder, { recursive: true });
    }
});
