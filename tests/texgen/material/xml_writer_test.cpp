// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/xml_writer.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(XmlWriter, IndentsElements) {
    XmlWriter xml;
    xml.begin("a", {});
    xml.comment("text");
    xml.element("b", {{"x", "1"}, {"y", "2"}});
    xml.begin("c", {{"z", ""}});
    xml.end();
    xml.end();
    EXPECT_EQ(xml.text(),
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<a>\n"
              "  <!-- text -->\n"
              "  <b x=\"1\" y=\"2\"/>\n"
              "  <c z=\"\">\n"
              "  </c>\n"
              "</a>\n");
}

TEST(XmlWriter, EscapesValues) {
    XmlWriter xml;
    xml.element("a", {{"x", "<&>\"'\n\t\r\x01\xc3\xa9"}});
    EXPECT_NE(xml.text().find("x=\"&lt;&amp;&gt;&quot;'&#10;&#9;&#13;?\xc3\xa9\""),
              std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
