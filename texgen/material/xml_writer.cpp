// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/xml_writer.h"

namespace foam::texgen {

namespace {

std::string escaped(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\n':
            return "&#10;";
        case '\t':
            return "&#9;";
        case '\r':
            return "&#13;";
        default:
            // XML does not allow other control characters. Bytes above 127 are parts of UTF-8.
            return std::string(1, static_cast<unsigned char>(c) < 0x20 ? '?' : c);
    }
}

}  // namespace

void XmlWriter::begin(std::string_view name, const Attributes& attributes) {
    open(name, attributes, ">\n");
    names_.emplace_back(name);
}

void XmlWriter::end() {
    const std::string name = names_.back();
    names_.pop_back();
    indent();
    text_ += "</" + name + ">\n";
}

void XmlWriter::element(std::string_view name, const Attributes& attributes) {
    open(name, attributes, "/>\n");
}

void XmlWriter::comment(std::string_view text) {
    indent();
    text_.append("<!-- ").append(text).append(" -->\n");
}

void XmlWriter::open(std::string_view name, const Attributes& attributes, std::string_view close) {
    indent();
    text_.append("<").append(name);
    for (const auto& [key, value] : attributes) {
        text_.append(" ").append(key).append("=\"");
        for (const char c : value) {
            text_ += escaped(c);
        }
        text_ += '"';
    }
    text_ += close;
}

void XmlWriter::indent() {
    text_.append(2 * names_.size(), ' ');
}

}  // namespace foam::texgen
