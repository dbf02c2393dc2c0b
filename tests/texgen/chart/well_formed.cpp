#include "tests/texgen/chart/well_formed.h"

#include <regex>
#include <vector>

namespace foam::texgen::test {

namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

// A tag, with quoted attributes after white space, or text in which & begins an entity.
const std::regex& token() {
    static const std::regex pattern(
        R"re(^(?:<(/?)([A-Za-z][\w:.-]*))re"
        R"re(((?:\s+[A-Za-z][\w:.-]*="(?:[^"<&]|&(?:amp|lt|gt|quot);)*")*))re"
        R"re(\s*(/?)>|[^<&]+|&(?:amp|lt|gt|quot);))re");
    return pattern;
}

}  // namespace

AssertionResult is_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    int roots = 0;
    for (auto rest = xml.cbegin(); rest != xml.cend();) {
        const auto at = rest - xml.cbegin();
        std::smatch found;
        if (!std::regex_search(rest, xml.cend(), found, token())) {
            return AssertionFailure() << "neither tag nor text at byte " << at;
        }
        const std::string name = found[2];
        if (name.empty() && open.empty() && found[0] != "\n") {
            return AssertionFailure() << "text outside the element at byte " << at;
        }
        if (found[1].length() > 0) {
            if (open.empty() || open.back() != name) {
                return AssertionFailure() << "</" << name << "> closes nothing at byte " << at;
            }
            open.pop_back();
        } else if (!name.empty()) {
            roots += open.empty() ? 1 : 0;
            if (found[4].length() == 0) {
                open.push_back(name);
            }
        }
        rest = found[0].second;
    }
    if (!open.empty() || roots != 1) {
        return AssertionFailure() << roots << " elements, " << open.size() << " not closed";
    }
    return AssertionSuccess();
}

}  // namespace foam::texgen::test
