// SPDX-License-Identifier: MIT
// The parts of the module, one a source.
#pragma once

namespace pybind11 {
class module_;
}

namespace stig::python {

void bind_scene(pybind11::module_& module);
void bind_search(pybind11::module_& module);
void bind_traces(pybind11::module_& module);

}  // namespace stig::python
