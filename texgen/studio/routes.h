// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_value.h"
#include "texgen/studio/bake_job.h"
#include "texgen/studio/folder.h"
#include "texgen/studio/frame_store.h"
#include "texgen/studio/http_message.h"
#include "texgen/studio/picture.h"

#include <functional>
#include <optional>
#include <string>

namespace foam::texgen {

/// The objects that are needed to answer the requests of a page.
struct StudioParts {
    const StudioFolder& folder;
    FrameStore& store;
    Painter& painter;
    BakeJobs& bakes;
};

/// Returns answer(request) for the JSON in the body of a request. Returns an error response of the
/// status BadRequest if the body is not JSON.
HttpResponse answer_json(const std::string& body,
                         const std::function<HttpResponse(const JsonValue& request)>& answer);

/// Returns the answer to a POST request that Access allows; nullopt if `target` is not one of the
/// paths in kRoutes (routes.cpp). Returns an error response if the body is not JSON. Throws
/// InputError if a member of the body is missing or malformed. Also throws the exceptions of the
/// functions that do the work.
std::optional<HttpResponse> answer_post(const std::string& target,
                                        const std::string& body,
                                        const StudioParts& parts);

/// Returns a response with JSON.
HttpResponse json_response(const Json& json);

}  // namespace foam::texgen
