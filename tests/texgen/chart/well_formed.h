#pragma once

#include <gtest/gtest.h>

#include <string>

namespace foam::texgen::test {

/// Whether a text is one well-formed XML element with what it holds, as far as documents without
/// declarations, comments and CDATA go; tells what is wrong and where.
::testing::AssertionResult is_well_formed(const std::string& xml);

}  // namespace foam::texgen::test
