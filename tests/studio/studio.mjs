// SPDX-License-Identifier: Apache-2.0
//
// Starts the program's studio and opens its page, for the tests in this folder.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm } from "node:fs/promises";
import http from "node:http";
import os from "node:os";
import path from "node:path";
import { launch_chromium, open_page } from "../browser/chromium.mjs";

export const program = process.env.FOAMTEX;

// Runs the program and returns what it prints on stdout. Throws an Error with its stderr if its exit code is not 0.
export async function run(arguments_, options = {}) {
    const child = spawn(program, arguments_, options);
    let out = "";
    let errors = "";
    child.stdout.on("data", (data) => (out += data));
    child.stderr.on("data", (data) => (errors += data));
    const [code] = await once(child, "close");
    if (code !== 0) {
        throw new Error(`foamtex ${arguments_.join(" ")} ended with ${code}: ${errors}`);
    }
    return out;
}

// Starts a studio in a folder. Returns its address, its port, the id of its process, and `stop`, which ends it and returns its
// exit code.
export async function start_studio(folder, options = []) {
    const child = spawn(program, ["studio", folder, "--no-browser", "--json", ...options]);
    const [line] = await once(child.stdout, "data");
    const { url, port } = JSON.parse(line);
    return {
        url,
        port,
        pid: child.pid,
        stop: async (signal = "SIGINT") => {
            if (child.exitCode !== null || child.signalCode !== null) {
                return child.exitCode;
            }
            child.kill(signal);
            const [code] = await once(child, "close");
            return code;
        },
    };
}

// Opens a session of a studio without a browser. Returns a function that posts a request and returns the body of the answer. Up
// to four requests can run at the same time. The function throws an Error if the status is not 200.
export async function open_session(studio) {
    const agent = new http.Agent({ keepAlive: true, maxSockets: 4 });
    const origin = `http://localhost:${studio.port}`;
    let cookie = "";
    const send = (target, body) =>
        new Promise((resolve, reject) => {
            const headers = { "Content-Type": "application/json", Origin: origin, "Sec-Fetch-Site": "same-origin", Cookie: cookie };
            const request = http.request(`${origin}${target}`, { method: "POST", agent, headers }, (response) => {
                const parts = [];
                response.on("data", (part) => parts.push(part));
                response.on("end", () => resolve({ response, body: Buffer.concat(parts) }));
            });
            request.on("error", reject);
            request.end(JSON.stringify(body));
        });
    const token = /token=([^&]+)/.exec(new URL(studio.url).hash)[1];
    const session = await send("/api/session", { token });
    cookie = session.response.headers["set-cookie"][0].split(";")[0];
    return async (target, body) => {
        const answer = await send(target, body);
        if (answer.response.statusCode !== 200) {
            throw new Error(`${target} was answered with ${answer.response.statusCode}: ${answer.body}`);
        }
        return answer.body;
    };
}

// Calls a test with a new folder, a studio in it and a browser, and removes all of them afterwards.
export async function with_studio(test) {
    const folder = await mkdtemp(path.join(os.tmpdir(), "foamtex-studio-"));
    const studio = await start_studio(folder);
    const browser = await launch_chromium();
    try {
        await test({ folder, studio, browser });
    } finally {
        await browser.close();
        await studio.stop();
        await rm(folder, { recursive: true });
    }
}

// Opens the page of a studio and waits until the first picture is exact. Returns the page and its errors. The browser reports
// each response 409 as an error, but it is expected: a request that waits for a foam is answered so if the page shows
// another foam meanwhile.
export async function open_studio(browser, url, { width = 1440, height = 900, colorScheme = "dark" } = {}) {
    const opened = await open_page(browser, { expected: /status of 409/ });
    await opened.page.setViewportSize({ width, height });
    await opened.page.emulateMedia({ colorScheme });
    await opened.page.goto(url);
    await wait_for_exact_picture(opened.page);
    return opened;
}

// Waits until the canvas shows a picture that is exact; with `after`, a picture that follows the one of this version.
export async function wait_for_exact_picture(page, after = 0) {
    await page.waitForFunction(
        (version) => {
            const { exact, version: shown } = document.getElementById("picture").dataset;
            return exact === "true" && Number(shown) > version;
        },
        after,
        { timeout: 60_000 },
    );
}

// Stops the loop at its first frame, and waits until its picture is exact.
export async function stop_loop(page) {
    if (await page.evaluate(() => window.studio.player.playing)) {
        await page.click("#play");
    }
    await page.click("#first");
    await wait_for_exact_picture(page);
}

// Returns the number of pictures that the page has shown.
export function version_of(page) {
    return page.evaluate(() => Number(document.getElementById("picture").dataset.version));
}

// Sets a key of the form, as a user does, and waits for the picture that follows.
export async function set_key(page, key, value) {
    const version = await version_of(page);
    await type_key(page, key, value);
    await wait_for_exact_picture(page, version);
}

// Enters a value into the control of a key, as a user does who searches for the key. `value` is a text, a number, or a list
// for a key with several numbers.
export async function type_key(page, key, value) {
    await page.fill("#form-search", key);
    const control = page.locator(`#form [data-key="${key}"]`);
    const kind = await control.evaluate((element) => element.getAttribute("role") ?? element.tagName);
    if (kind === "SELECT") {
        await control.selectOption(value);
    } else if (kind === "radiogroup") {
        await control.getByText(value, { exact: true }).click();
    } else if (kind === "group") {
        for (const [index, item] of value.entries()) {
            await control.locator("input").nth(index).fill(String(item));
        }
        await control.locator("input").last().press("Enter");
    } else {
        await control.fill(String(value));
        await control.press("Enter");
    }
    await page.fill("#form-search", "");
}

// Returns the pixels of the picture, as a list of R, G, B and A, at the zoom of one device pixel for each pixel of the
// preset. The picture must fit into the canvas.
export async function shown_pixels(page, width, height) {
    await page.click("#zoom-pixels");
    return page.evaluate(
        ([width_, height_]) => {
            const canvas = document.getElementById("picture");
            const left = Math.round((canvas.width - width_) / 2);
            const top = Math.round((canvas.height - height_) / 2);
            return [...canvas.getContext("2d").getImageData(left, top, width_, height_).data];
        },
        [width, height],
    );
}

// Decodes a PNG in the browser. Returns its pixels as a list of R, G, B and A.
export function decoded_png(page, bytes) {
    return page.evaluate(async (base64) => {
        const response = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        const image = await createImageBitmap(new Blob([response], { type: "image/png" }), {
            colorSpaceConversion: "none",
            premultiplyAlpha: "none",
        });
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        return [...context.getImageData(0, 0, image.width, image.height).data];
    }, bytes.toString("base64"));
}
