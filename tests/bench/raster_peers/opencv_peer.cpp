// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/raster_peers/peers.h"

#include <opencv2/imgproc.hpp>

#include <memory>

namespace foam::bench {

DistanceTransform opencv_transform(int side) {
    const auto distances = std::make_shared<cv::Mat>(side, side, CV_32F);
    cv::setNumThreads(1);
    const auto transform = [distances](const texgen::Image<std::uint8_t>& mask) {
        auto* samples = const_cast<std::uint8_t*>(mask.samples().data());  // cv::Mat takes no const
        const cv::Mat input(mask.height(), mask.width(), CV_8U, samples);
        cv::distanceTransform(input, *distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    };
    return {"OpenCV", transform};
}

}  // namespace foam::bench
