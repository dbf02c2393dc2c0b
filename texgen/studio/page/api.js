// SPDX-License-Identifier: Apache-2.0

// Sends the requests of the page to the server. ../REQUESTS.md describes them.

import {Signal} from "./signal.js";

const kRetry = 2000; // milliseconds between two attempts to reach a server that is gone
const kAlive = 20000; // milliseconds between two requests that tell the server that this page is open

/** An answer of the server that is an error: its HTTP status, its message, and the preset key that it is about. */
export class ApiError extends Error {
    constructor(status, message, key) {
        super(message);
        this.status = status;
        this.key = key;
    }
}

/** Reports that the server cannot be reached, or that the connection broke off during an answer. */
export class ConnectionError extends Error {}

/** A random word that tells the server which page asks. */
export const page = crypto.randomUUID?.() ?? String(Math.random()).slice(2);

/** Emits "online", "offline" or "forbidden" (the server denies access) when the connection changes. */
export const connection = new Signal();
let state = "online";

/** Returns "online", "offline" or "forbidden". */
export const connectionState = () => state;

function setState(next) {
    if (next === state) {
        return;
    }
    state = next;
    connection.emit(state);
    if (state !== "online") {
        clearTimeout(retry);
        retry = setTimeout(tryAgain, kRetry);
    }
}

let retry = 0;

async function tryAgain() {
    try {
        await getProgram();
    } catch {
        clearTimeout(retry);
        retry = setTimeout(tryAgain, kRetry);
    }
}

async function errorOf(response) {
    try {
        const {error} = await response.json();
        return new ApiError(response.status, error.message, error.key);
    } catch {
        return new ApiError(response.status, `The server answered with status ${response.status}.`, null);
    }
}

// Returns what `promise`, a call of `fetch` or the reading of a body, gives. If the connection fails, throws
// ConnectionError. An AbortError is passed on.
async function received(promise) {
    try {
        return await promise;
    } catch (error) {
        if (error.name === "AbortError") {
            throw error;
        }
        setState("offline");
        throw new ConnectionError("The program cannot be reached.", {cause: error});
    }
}

async function send(path, options) {
    const response = await received(fetch(path, {credentials: "same-origin", ...options}));
    setState(response.status === 403 ? "forbidden" : "online");
    if (!response.ok) {
        throw await errorOf(response);
    }
    return response;
}

const jsonOf = async (response) => JSON.parse(await received(response.text()));

const postOptions = (body, signal) => ({
    method: "POST",
    headers: {"Content-Type": "application/json"},
    body: JSON.stringify(body),
    signal,
});

/** Posts a request and returns the JSON of the answer, or null if it is empty. Throws ApiError and ConnectionError. */
export async function post(path, body, signal) {
    const response = await send(path, postOptions(body, signal));
    return response.status === 204 ? null : jsonOf(response);
}

/** Returns what the program can do: presets, maps, profiles, the schema of preset files. */
export const getProgram = async () => jsonOf(await send("/api/program", {}));

/**
 * Requests the samples of an image from `path`, which is /api/picture or /api/baked. Returns an object with the members
 * of the header X-Foamtex-Picture, and with the samples as `pixels` (ImageData) or, if `body.samples` is "float", as
 * `numbers` (Float32Array). Throws ApiError and ConnectionError.
 */
export async function postPicture(path, body, signal) {
    const response = await send(path, postOptions({page, ...body}, signal));
    const info = JSON.parse(response.headers.get("X-Foamtex-Picture"));
    const buffer = await received(response.arrayBuffer());
    if (body.samples === "float") {
        return {...info, numbers: new Float32Array(buffer)};
    }
    return {...info, pixels: new ImageData(new Uint8ClampedArray(buffer), info.width, info.height)};
}

/**
 * Requests a file from /api/download. The browser saves the file under the name that the server gives, or under
 * `fallback` if the server gives none. Returns this name.
 */
export async function download(body, fallback) {
    const response = await send("/api/download", postOptions({page, ...body}));
    const name = /filename="?([^";]+)/.exec(response.headers.get("Content-Disposition") ?? "")?.[1] ?? fallback;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await received(response.blob()));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    return name;
}

/**
 * Exchanges the token in the fragment of the address for a cookie. Removes the fragment, so that the token does not
 * stay in the history of the browser.
 */
export async function startSession() {
    const token = /token=([^&]+)/.exec(location.hash)?.[1] ?? /^#([0-9A-Za-z_-]{16,})$/.exec(location.hash)?.[1];
    if (!token) {
        return;
    }
    history.replaceState(null, "", location.pathname);
    try {
        await post("/api/session", {token});
    } catch (error) {
        if (!(error instanceof ApiError)) {
            throw error;
        }
    }
}

/** Tells the server regularly that this page is open, so that the server does not end. */
export function keepAlive() {
    setInterval(() => {
        if (state === "online") {
            post("/api/alive", {page}).catch(() => {});
        }
    }, kAlive);
}
