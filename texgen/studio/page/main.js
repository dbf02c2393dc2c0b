// SPDX-License-Identifier: Apache-2.0

// Starts the page.

import {connection, connectionState, getProgram, keepAlive, startSession} from "./api.js";
import {showConnection} from "./banner.js";
import {Studio} from "./studio.js";
import {startTheme} from "./theme.js";

async function start() {
    startTheme();
    connection.on(showConnection);
    try {
        await startSession();
        const studio = new Studio(await getProgram());
        // Tests and the console of the browser reach the parts of the page through this name.
        window.studio = studio;
        studio.start();
        keepAlive();
    } catch (error) {
        if (connectionState() === "online") {
            throw error;
        }
        connection.on((state) => state === "online" && location.reload());
    }
}

start();
