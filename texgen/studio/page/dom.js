// SPDX-License-Identifier: Apache-2.0

// Creates elements of the page. No module writes HTML as text, so that a name from a file can never become markup.

const kSvg = "http://www.w3.org/2000/svg";

/** Returns the element with an id that index.html contains. */
export const $ = (id) => document.getElementById(id);

/**
 * Creates an element. Properties that start with "on" are event listeners, "class" is the class, "data" is an object of
 * data attributes. A property whose value is true is set without a value; one whose value is false or null is left out.
 */
export function el(tag, properties = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(properties)) {
        if (name === "data") {
            Object.assign(element.dataset, value);
        } else if (name.startsWith("on")) {
            element.addEventListener(name.slice(2), value);
        } else if (value !== false && value !== null && value !== undefined) {
            element.setAttribute(name, value === true ? "" : value);
        }
    }
    element.append(...children.filter((child) => child !== null && child !== undefined));
    return element;
}

/** Returns an image of the icon with this name. The symbols are in index.html. Icons are hidden from screen readers. */
export function icon(name) {
    const svg = document.createElementNS(kSvg, "svg");
    svg.setAttribute("class", "icon");
    svg.setAttribute("aria-hidden", "true");
    const use = document.createElementNS(kSvg, "use");
    use.setAttribute("href", `#i-${name}`);
    svg.append(use);
    return svg;
}

/** Returns a button that shows only an icon. The label is its accessible name and its tooltip. */
export function iconButton(name, label, onclick, properties = {}) {
    return el(
        "button",
        {type: "button", class: "icon-button", "aria-label": label, title: label, onclick, ...properties},
        icon(name),
    );
}

/** Shows another icon in a button that `iconButton` made. */
export function setIcon(button, name) {
    button.querySelector("use").setAttribute("href", `#i-${name}`);
}

/** Sets the accessible name and the tooltip of a button. */
export function setLabel(button, label) {
    button.setAttribute("aria-label", label);
    button.title = label;
}

/**
 * Returns a function `call`. When `milliseconds` have passed since the last call of `call`, `action` is called once,
 * with the arguments of this last call. `call.cancel()` prevents this.
 */
export function debounce(milliseconds, action) {
    let timer = 0;
    const call = (...values) => {
        clearTimeout(timer);
        timer = setTimeout(() => action(...values), milliseconds);
    };
    call.cancel = () => clearTimeout(timer);
    return call;
}

/** Returns how far an event "wheel" scrolls down, in CSS pixels. `deltaY` may count pixels, lines or pages. */
export const wheelPixels = (event) => event.deltaY * [1, 20, 400][event.deltaMode];

/** Returns true if the user asked the system for less motion. */
export const reducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Returns the value, or the nearest limit. */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
