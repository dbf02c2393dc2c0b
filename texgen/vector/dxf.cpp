// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/dxf.h"

#include "core/geometry/elementary.h"
#include "texgen/vector/number_text.h"

#include <fmt/core.h>

#include <string_view>

// A DXF file is a list of groups. Each group consists of two lines: a code and a value. AutoCAD
// 2000 requires the tables, blocks and objects below, even if they are empty. Every item has a
// handle, a unique hexadecimal number. The group with the code 330 gives the handle of the owner.

namespace foam::texgen {

namespace {

// Codes of the AutoCAD Color Index (ACI). Color 7 is black on a white background, and white on a
// black one.
constexpr int kBlackOrWhite = 7;
constexpr int kRed = 1;
constexpr int kGray = 8;

constexpr std::string_view kModelSpace = "1F";
constexpr std::string_view kPaperSpace = "1E";
constexpr std::string_view kRootDictionary = "C";

// Returns a text as one line of printable ASCII: every other byte is replaced by a question mark.
std::string ascii_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        line += c >= ' ' && c <= '~' ? c : '?';
    }
    return line;
}

class DxfWriter {
  public:
    void group(int code, std::string_view value) {
        text_ += fmt::format("{:3}\n{}\n", code, value);
    }
    void group(int code, int value) { text_ += fmt::format("{:3}\n{:6}\n", code, value); }
    void real(int code, double value) { group(code, exact_text(value)); }
    void point(const Vec2& position) {
        real(10, position.x());
        real(20, position.y());
    }

    /// Writes the start of an item: its type, a new handle, and the handle of its owner.
    void item(std::string_view type, std::string_view owner) {
        group(0, type);
        group(5, fmt::format("{:X}", next_handle_++));
        group(330, owner);
    }
    void section(std::string_view name) {
        group(0, "SECTION");
        group(2, name);
    }
    void end_section() { group(0, "ENDSEC"); }
    /// Writes the start of a table. Returns the handle of the table. The table is the owner of its
    /// entries.
    std::string table(std::string_view name, int entries) {
        group(0, "TABLE");
        group(2, name);
        std::string handle = fmt::format("{:X}", next_handle_++);
        group(5, handle);
        group(330, "0");
        group(100, "AcDbSymbolTable");
        group(70, entries);
        return handle;
    }
    void end_table() { group(0, "ENDTAB"); }
    /// Writes the start of an entry of a table.
    void entry(std::string_view type,
               std::string_view table,
               std::string_view class_name,
               std::string_view name) {
        item(type, table);
        group(100, "AcDbSymbolTableRecord");
        group(100, class_name);
        group(2, name);
        group(70, 0);
    }
    void entity(std::string_view type, std::string_view layer, std::string_view class_name) {
        item(type, kModelSpace);
        group(100, "AcDbEntity");
        group(8, layer);
        group(100, class_name);
    }

    const std::string& text() const { return text_; }

  private:
    std::string text_;
    unsigned next_handle_ = 0x100;  // above all fixed handles
};

void write_header(const Drawing& drawing, DxfWriter& dxf) {
    dxf.group(999, ascii_line(drawing.title));
    dxf.section("HEADER");
    dxf.group(9, "$ACADVER");
    dxf.group(1, "AC1015");
    dxf.group(9, "$HANDSEED");
    dxf.group(5, "FFFFFF");
    dxf.group(9, "$INSUNITS");
    dxf.group(70, 4);  // millimeters
    dxf.group(9, "$MEASUREMENT");
    dxf.group(70, 1);  // metric
    dxf.group(9, "$EXTMIN");
    dxf.point(drawing.page_box().low);
    dxf.real(30, 0.0);
    dxf.group(9, "$EXTMAX");
    dxf.point(drawing.page_box().high);
    dxf.real(30, 0.0);
    dxf.end_section();
}

// Writes the view that a program shows when it opens the file.
void write_view(const Drawing& drawing, DxfWriter& dxf) {
    const std::string table = dxf.table("VPORT", 1);
    dxf.entry("VPORT", table, "AcDbViewportTableRecord", "*ACTIVE");
    const auto pair = [&](int code, double x, double y) {
        dxf.real(code, x);
        dxf.real(code + 10, y);
    };
    pair(10, 0.0, 0.0);
    pair(11, 1.0, 1.0);
    const Box box = drawing.page_box();
    const Vec2 center = 0.5 * (box.low + box.high);
    const Vec2 size = box.high - box.low;
    pair(12, center.x(), center.y());
    dxf.real(40, 1.1 * size.y());
    dxf.real(41, size.x() / size.y());
    dxf.end_table();
}

void write_line_types(DxfWriter& dxf) {
    const std::string table = dxf.table("LTYPE", 3);
    for (const char* const name : {"ByBlock", "ByLayer", "Continuous"}) {
        dxf.entry("LTYPE", table, "AcDbLinetypeTableRecord", name);
        dxf.group(3, "");
        dxf.group(72, 65);
        dxf.group(73, 0);
        dxf.real(40, 0.0);
    }
    dxf.end_table();
}

void write_layers(const Drawing& drawing, DxfWriter& dxf) {
    const std::string table = dxf.table("LAYER", static_cast<int>(drawing.layers.size()) + 2);
    const auto add = [&](std::string_view name, int color) {
        dxf.entry("LAYER", table, "AcDbLayerTableRecord", name);
        dxf.group(62, color);
        dxf.group(6, "Continuous");
    };
    add("0", kBlackOrWhite);
    for (const Layer& layer : drawing.layers) {
        if (layer.is_tool_path) {
            add(layer.name, layer.name == "solution" ? kRed : kBlackOrWhite);
        }
    }
    add("junctions", kGray);
    dxf.end_table();
}

void write_other_tables(DxfWriter& dxf) {
    const std::string styles = dxf.table("STYLE", 1);
    dxf.entry("STYLE", styles, "AcDbTextStyleTableRecord", "Standard");
    for (const int code : {40, 50, 42}) {
        dxf.real(code, code == 42 ? 2.5 : 0.0);
    }
    dxf.real(41, 1.0);
    dxf.group(71, 0);
    dxf.group(3, "txt");
    dxf.group(4, "");
    dxf.end_table();
    for (const char* const empty : {"VIEW", "UCS"}) {
        dxf.table(empty, 0);
        dxf.end_table();
    }
    const std::string programs = dxf.table("APPID", 1);
    dxf.entry("APPID", programs, "AcDbRegAppTableRecord", "ACAD");
    dxf.end_table();
    dxf.table("DIMSTYLE", 0);
    dxf.group(100, "AcDbDimStyleTable");
    dxf.end_table();
}

void write_tables(const Drawing& drawing, DxfWriter& dxf) {
    dxf.section("TABLES");
    write_view(drawing, dxf);
    write_line_types(dxf);
    write_layers(drawing, dxf);
    write_other_tables(dxf);
    const std::string records = dxf.table("BLOCK_RECORD", 2);
    for (const auto& [name, handle] :
         {std::pair{"*Model_Space", kModelSpace}, std::pair{"*Paper_Space", kPaperSpace}}) {
        dxf.group(0, "BLOCK_RECORD");
        dxf.group(5, handle);
        dxf.group(330, records);
        dxf.group(100, "AcDbSymbolTableRecord");
        dxf.group(100, "AcDbBlockTableRecord");
        dxf.group(2, name);
    }
    dxf.end_table();
    dxf.end_section();
}

void write_blocks(DxfWriter& dxf) {
    dxf.section("BLOCKS");
    for (const auto& [name, owner] :
         {std::pair{"*Model_Space", kModelSpace}, std::pair{"*Paper_Space", kPaperSpace}}) {
        dxf.item("BLOCK", owner);
        dxf.group(100, "AcDbEntity");
        dxf.group(8, "0");
        dxf.group(100, "AcDbBlockBegin");
        dxf.group(2, name);
        dxf.group(70, 0);
        dxf.point({0.0, 0.0});
        dxf.real(30, 0.0);
        dxf.group(3, name);
        dxf.group(1, "");
        dxf.item("ENDBLK", owner);
        dxf.group(100, "AcDbEntity");
        dxf.group(8, "0");
        dxf.group(100, "AcDbBlockEnd");
    }
    dxf.end_section();
}

// The bulge of an arc is the tangent of a quarter of the angle by which it turns left. The last arc
// of a closed polyline leads back to the first vertex.
void write_chain(const Chain& chain, std::string_view layer, DxfWriter& dxf) {
    const std::vector<DrawnArc> arcs = arcs_of(chain);
    dxf.entity("LWPOLYLINE", layer, "AcDbPolyline");
    dxf.group(90, static_cast<int>(arcs.size()) + (chain.is_closed ? 0 : 1));
    dxf.group(70, chain.is_closed ? 1 : 0);
    for (const DrawnArc& arc : arcs) {
        dxf.point(arc.tail);
        dxf.real(42, ieee::tan(0.5 * arc.half_angle));
    }
    if (!chain.is_closed) {
        dxf.point(chain.head());
    }
}

void write_entities(const Drawing& drawing, DxfWriter& dxf) {
    dxf.section("ENTITIES");
    for (const Layer& layer : drawing.layers) {
        for (const Shape& shape : layer.is_tool_path ? layer.shapes : std::vector<Shape>()) {
            for (const Chain& chain : shape.chains) {
                write_chain(chain, layer.name, dxf);
            }
        }
    }
    for (const Vec2& junction : drawing.junctions) {
        dxf.entity("POINT", "junctions", "AcDbPoint");
        dxf.point(junction);
        dxf.real(30, 0.0);
    }
    dxf.end_section();
}

void write_objects(DxfWriter& dxf) {
    constexpr std::string_view kGroups = "D";
    dxf.section("OBJECTS");
    dxf.group(0, "DICTIONARY");
    dxf.group(5, kRootDictionary);
    dxf.group(330, "0");
    dxf.group(100, "AcDbDictionary");
    dxf.group(281, 1);
    dxf.group(3, "ACAD_GROUP");
    dxf.group(350, kGroups);
    dxf.group(0, "DICTIONARY");
    dxf.group(5, kGroups);
    dxf.group(330, kRootDictionary);
    dxf.group(100, "AcDbDictionary");
    dxf.group(281, 1);
    dxf.end_section();
}

}  // namespace

std::string to_dxf(const Drawing& drawing) {
    DxfWriter dxf;
    write_header(drawing, dxf);
    write_tables(drawing, dxf);
    write_blocks(dxf);
    write_entities(drawing, dxf);
    write_objects(dxf);
    dxf.group(0, "EOF");
    return dxf.text();
}

}  // namespace foam::texgen
