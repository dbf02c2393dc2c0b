// SPDX-License-Identifier: Apache-2.0

// Creates the parts of the page that surround the picture and the form of the keys. Each part gets the object of the
// class Studio, through which it reaches the other parts.

import {BakeDialog} from "./bake.js";
import {Compare} from "./compare.js";
import {EventTrack} from "./events.js";
import {Gallery} from "./gallery.js";
import {Lit} from "./lit.js";
import {Readout} from "./readout.js";
import {Shortcuts} from "./keys.js";
import {StatusBar} from "./status.js";
import {TakeHome} from "./take_home.js";
import {Toolbar} from "./toolbar.js";
import {Transport} from "./transport.js";
import {Variations} from "./variations.js";

/** Creates all parts and stores them in the studio. */
export function createParts(studio) {
    studio.status = new StatusBar(studio);
    studio.toolbar = new Toolbar(studio);
    studio.transport = new Transport(studio);
    studio.readout = new Readout(studio);
    studio.events = new EventTrack(studio);
    studio.compare = new Compare(studio);
    studio.variations = new Variations(studio);
    studio.lit = new Lit(studio);
    studio.bake = new BakeDialog(studio);
    studio.takeHome = new TakeHome(studio);
    studio.gallery = new Gallery(studio);
    studio.shortcuts = new Shortcuts(studio);
}
