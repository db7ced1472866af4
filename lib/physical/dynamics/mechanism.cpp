// SPDX-License-Identifier: MIT
#include "physical/dynamics/mechanism.h"

namespace stig {

#if STIG_WITH_DART
bool mechanisms_available() { return true; }
std::shared_ptr<Mechanism> make_mechanism(const std::vector<Part>& parts) {
  return make_dart_mechanism(parts);
}
#else
bool mechanisms_available() { return false; }
std::shared_ptr<Mechanism> make_mechanism(const std::vector<Part>&) { return nullptr; }
#endif

}  // namespace stig
