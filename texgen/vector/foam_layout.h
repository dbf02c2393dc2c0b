// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/per_bubble.h"
#include "texgen/vector/chain.h"
#include "texgen/vector/page.h"
#include "texgen/vector/vector_options.h"

#include <functional>
#include <vector>

namespace foam::texgen {

/// Selects films.
using FilmFilter = std::function<bool(FilmId)>;

/// Places the bubbles and the films of a frame on a page. Borrows the frame.
///
/// On a torus with VectorWrap::Cut, bubbles and films are cut at the border of the tile, and each
/// part is drawn once. With VectorWrap::Whole, each bubble is drawn once, at the position at which
/// its centroid is in the tile. Each film beside a drawn bubble is drawn. A film between two
/// bubbles that are on opposite sides of the tile is drawn on both sides. In the plane, nothing is
/// cut.
class FoamLayout {
  public:
    FoamLayout(const Frame& frame, const Page& page, VectorWrap wrap);

    /// Returns true if arcs are cut at the border of the tile.
    bool is_cut() const { return is_cut_; }

    /// Returns the outlines of every bubble, counter-clockwise: one closed chain, or several if the
    /// bubble is cut.
    PerBubble<std::vector<Chain>> bubbles() const;

    /// Returns the arcs of the chosen films and of all lone bubbles. Films that are cut are given
    /// as their parts, moved into the tile. Arcs share a node if they meet in a junction.
    std::vector<NetArc> lines(const FilmFilter& is_chosen) const;

    /// Returns the whole arcs of all copies of the chosen films that come within `reach`
    /// millimeters of the tile (copies_near_tile). If nothing is cut, returns the result of
    /// `lines`.
    std::vector<NetArc> lines_near_tile(const FilmFilter& is_chosen, double reach) const;

    /// Returns the parts of the arcs of lines_near_tile that are outside of the tile and come
    /// within `reach` millimeters of it (parts_beyond_tile). The result is empty if nothing is cut.
    std::vector<DrawnArc> lines_beyond_tile(const FilmFilter& is_chosen, double reach) const;

    /// Returns the positions of all junctions on the page, each once. On a torus they are in the
    /// tile, even if bubbles are drawn whole.
    std::vector<Vec2> junctions() const;

  private:
    Chain whole_bubble(BubbleId bubble) const;
    std::vector<NetArc> cut_lines(const FilmFilter& is_chosen) const;
    std::vector<NetArc> whole_lines(const FilmFilter& is_chosen) const;
    LatticeOffset drawn_offset(BubbleId bubble) const;
    void add_lone_bubbles(std::vector<NetArc>& lines) const;

    const Frame& frame_;
    Page page_;
    bool is_cut_;
};

}  // namespace foam::texgen
