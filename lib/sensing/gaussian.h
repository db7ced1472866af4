// SPDX-License-Identifier: MIT
// Gaussian noise, which most sensors' errors are.
#pragma once

#include "base/random.h"

namespace stig::sensing {

/// A sample of mean 0 and standard deviation 1 (Box and Muller 1958).
double gaussian(Random& random);

}  // namespace stig::sensing
