// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_element.h"

#include "core/files/file_io.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

// An inch has 96 pixels, 25.4 mm, 72 points and 6 picas.
TEST(SvgElement, LengthsHaveUnits) {
    EXPECT_EQ(parse_svg_length("2.5"), 2.5);
    EXPECT_EQ(parse_svg_length(" 1in "), 96.0);
    EXPECT_NEAR(*parse_svg_length("25.4mm"), 96.0, 1e-12);
    EXPECT_NEAR(*parse_svg_length("2.54cm"), 96.0, 1e-12);
    EXPECT_EQ(parse_svg_length("72pt"), 96.0);
    EXPECT_EQ(parse_svg_length("6pc"), 96.0);
    EXPECT_EQ(parse_svg_length("25%", 200.0), 50.0);
    EXPECT_FALSE(parse_svg_length("25%"));
    EXPECT_FALSE(parse_svg_length("2em"));
    EXPECT_FALSE(parse_svg_length(""));
    EXPECT_FALSE(parse_svg_length("1 2"));
}

TEST(SvgElement, HasNamePropertiesAndLengths) {
    pugi::xml_document xml;
    ASSERT_TRUE(xml.load_string(
        "<svg:rect fill='red' style='fill : none;opacity:0' clip='inherit' x='auto' y='3em'/>"));
    const pugi::xml_node node = xml.document_element();
    EXPECT_EQ(element_name(node), "rect");
    EXPECT_EQ(element_property(node, "fill"), "none");
    EXPECT_EQ(element_property(node, "opacity"), "0");
    EXPECT_EQ(element_property(node, "clip"), "");
    EXPECT_EQ(element_property(node, "display"), "");
    EXPECT_FALSE(element_length(node, "x"));
    EXPECT_FALSE(element_length(node, "width"));
    EXPECT_THROW(element_length(node, "y"), InputError);
}

// The rules of CSS: the last value counts, but not if an earlier one is important.
TEST(SvgElement, StylesMayRepeatAProperty) {
    pugi::xml_document xml;
    ASSERT_TRUE(
        xml.load_string("<rect style='fill:red; fill:none; display:none !important; display:block; "
                        "opacity:1; opacity:0 !important; a!b:c'/>"));
    const pugi::xml_node node = xml.document_element();
    EXPECT_EQ(element_property(node, "fill"), "none");
    EXPECT_EQ(element_property(node, "display"), "none");
    EXPECT_EQ(element_property(node, "opacity"), "0");
    EXPECT_EQ(element_property(node, "a!b"), "");
}

}  // namespace
}  // namespace foam::texgen
