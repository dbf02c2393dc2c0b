// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/neighbor_mean.h"

#include "core/geometry/film_arc.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

namespace {

// A film between two bubbles.
struct Contact {
    std::size_t left;
    std::size_t right;
    double length;
};

std::vector<Contact> contacts_of(const Frame& frame) {
    std::vector<Contact> contacts;
    for (const FilmId film : frame.network.films()) {
        if (!frame.network.is_outer(film)) {
            const HalfEdgeId side = forward_side(film);
            contacts.push_back({index_of(frame.network.left(side)),
                                index_of(frame.network.right(side)),
                                arc_length(frame.arcs[film])});
        }
    }
    return contacts;
}

}  // namespace

void average_with_neighbors(const Frame& frame, int rounds, PerBubble<double>& values) {
    const std::vector<Contact> contacts = contacts_of(frame);
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> sums(frame.bubbles.size(), 0.0);
        std::vector<double> weights(frame.bubbles.size(), 0.0);
        for (const Contact& contact : contacts) {
            sums[contact.left] += contact.length * values[contact.right];
            sums[contact.right] += contact.length * values[contact.left];
            weights[contact.left] += contact.length;
            weights[contact.right] += contact.length;
        }
        for (std::size_t k = 0; k < sums.size(); ++k) {
            if (weights[k] > 0.0) {
                values[k] = 0.5 * (values[k] + sums[k] / weights[k]);
            }
        }
    }
}

}  // namespace foam::texgen
