// SPDX-License-Identifier: Apache-2.0
//
// Starts Debian's Chromium without a window, through playwright-core.

import path from "node:path";
import { import_package } from "./packages.mjs";

// The flags of a browser that draws WebGL 2 with the processor (SwiftShader) and sends nothing over the network by itself.
// The sandbox of Chromium does not work for root and in containers.
const flags = [
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--force-color-profile=srgb",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

// Returns the path of Chromium: the value of the environment variable FOAM_CHROMIUM, or Debian's program.
export function chromium_path() {
    return process.env.FOAM_CHROMIUM || "/usr/bin/chromium";
}

// Starts a browser with an empty profile, which is removed when the browser is closed. Returns playwright's object Browser.
// `options` are further options of playwright's chromium.launch; `options.args` are appended to the flags.
export async function launch_chromium(options = {}) {
    const playwright = (await import_package("browser", "playwright-core")).default;
    return playwright.chromium.launch({
        executablePath: chromium_path(),
        headless: true,
        ...options,
        args: [...flags, ...(options.args ?? [])],
    });
}

// Opens a page, with cookies of its own, whose errors are collected: messages of the console of type "error" that `expected`
// does not match, and exceptions that no code caught. Returns the page and the list, which grows.
export async function open_page(browser, { expected = /^$/ } = {}) {
    const context = await browser.newContext();
    const page = await context.newPage();
    const errors = [];
    page.on("console", (message) => {
        if (message.type() === "error" && !expected.test(message.text())) {
            errors.push(message.text());
        }
    });
    page.on("pageerror", (error) => errors.push(error.message));
    return { page, errors };
}

const media_types = {
    ".html": "text/html",
    ".js": "text/javascript",
    ".json": "application/json",
    ".mjs": "text/javascript",
    ".png": "image/png",
    ".wasm": "application/wasm",
};

// Answers all requests of a page from memory and from folders, without a server. `documents` has the text of a document
// by its path ("/index.html"), `folders` a folder of files by the path with which their addresses begin ("/three/"). The
// page finds them at any http address, such as http://test.invalid/index.html.
export async function serve(page, { documents = {}, folders = {} }) {
    await page.route("**/*", (route) => {
        const name = new URL(route.request().url()).pathname;
        const contentType = media_types[path.extname(name)] ?? "application/octet-stream";
        if (name in documents) {
            return route.fulfill({ body: documents[name], contentType });
        }
        const prefix = Object.keys(folders).find((start) => name.startsWith(start));
        return prefix === undefined
            ? route.fulfill({ status: 404 })
            : route.fulfill({ path: path.join(folders[prefix], name.slice(prefix.length)), contentType });
    });
}
