// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Writes an XML document. Values of attributes are escaped; control characters in them that XML
/// does not allow are replaced by '?'. Names and comments are not escaped.
class XmlWriter {
  public:
    using Attributes = std::vector<std::pair<std::string_view, std::string>>;

    /// Begins an element, whose content follows until `end`.
    void begin(std::string_view name, const Attributes& attributes);
    /// Ends the innermost element that has not been ended. Precondition: there is one.
    void end();
    /// Writes an element without content.
    void element(std::string_view name, const Attributes& attributes);
    /// Writes a comment. Precondition: the text does not contain "--".
    void comment(std::string_view text);

    /// Returns the document. Precondition: all elements have been ended.
    const std::string& text() const { return text_; }

  private:
    void open(std::string_view name, const Attributes& attributes, std::string_view close);
    void indent();

    std::string text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    std::vector<std::string> names_;  // names of the elements that have not been ended
};

}  // namespace foam::texgen
