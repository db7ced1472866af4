// SPDX-License-Identifier: MIT
// Traces of both worlds as arrays.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>

#include "base/file_io.h"
#include "lattice/trace.h"
#include "module.h"
#include "physical/trace/pose_frames.h"
#include "uses.h"

namespace stig::python {
namespace {

namespace py = pybind11;

constexpr std::size_t kMostTraceBytes = std::size_t{4} << 30;

std::string bytes_of(const std::string& path) {
  FileError error;
  auto bytes = read_file(path, kMostTraceBytes, error);
  if (!bytes) throw py::value_error(error.message);
  return std::move(*bytes);
}

py::dict deposits_in(const std::string& path) {
  Diagnostics diagnostics;
  const auto trace = lattice::read_trace(path, bytes_of(path), diagnostics);
  if (!trace) throw py::value_error(to_text(diagnostics));
  py::array_t<std::int64_t> rows({trace->events.size(), std::size_t{7}});
  std::int64_t* at = rows.mutable_data();
  for (const lattice::Deposit& d : trace->events) {
    for (const std::int64_t value :
         {static_cast<std::int64_t>(d.step), std::int64_t{d.agent}, std::int64_t{d.site.x},
          std::int64_t{d.site.y}, std::int64_t{d.site.z}, std::int64_t{d.colour},
          static_cast<std::int64_t>(d.match.rule)}) {
      *at++ = value;
    }
  }
  py::dict out;
  out["rules"] = trace->rule_set_yaml;
  out["steps"] = trace->steps;
  out["deposits"] = rows;
  return out;
}

/// Frames one after the other; what has left has no place.
void put_frame(const physics::TraceFrame& frame, std::vector<double>& out) {
  for (const physics::TraceState& state : frame.bodies) {
    const Pose X = state.pose();
    for (const double value : {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z}) {
      out.push_back(state.left ? std::numeric_limits<double>::quiet_NaN() : value);
    }
  }
}

py::dict poses_in(const std::string& path) {
  Diagnostics diagnostics;
  const auto trace = physics::read_pose_trace(path, bytes_of(path), diagnostics);
  if (!trace) throw py::value_error(to_text(diagnostics));
  std::vector<double> times, poses;
  for_each_frame(*trace, [&](const physics::TraceFrame& frame) {
    times.push_back(static_cast<double>(frame.tick) * trace->header.step);
    put_frame(frame, poses);
  });
  std::vector<std::string> names;
  for (const physics::TraceBody& body : trace->header.bodies) names.push_back(body.name);
  py::array_t<double> all({times.size(), names.size(), std::size_t{7}});
  std::copy(poses.begin(), poses.end(), all.mutable_data());
  py::dict out;
  out["names"] = names;
  out["times"] = py::array_t<double>(static_cast<py::ssize_t>(times.size()), times.data());
  out["poses"] = all;
  out["seed"] = trace->header.seed;
  out["end"] = std::string(to_string(trace->end.why));
  return out;
}

}  // namespace

void bind_traces(py::module_& module) {
  module.def("deposits_in", &deposits_in);
  module.def("poses_in", &poses_in);
}

}  // namespace stig::python
