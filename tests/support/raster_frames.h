#pragma once

#include "tests/support/sample_foams.h"
