-- SPDX-License-Identifier: MIT
return { type = 3 }
