// SPDX-License-Identifier: MIT
// Certificates made wrong, for tests; some changes leave what is true true.
#pragma once

#include "certify/certificate.h"
#include "support/uses.h"

namespace stig {

/// One change drawn by lot: a brick moved, recoloured, left out or swapped with another;
/// `before` flipped or emptied; a far fact or a filling put in or taken away. Inside
/// rc::check; the certificate has a stage.
void change_somewhere(Certificate& certificate);

}  // namespace stig
