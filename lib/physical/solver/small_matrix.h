// SPDX-License-Identifier: MIT
// Dense matrices of a mechanism's size, row by row in a vector.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stig::physics {

/// The inverse of a positive definite matrix of which the lower half is given, in place; the same
/// by rows and by columns. Innermost are sums of different numbers, which need not wait for each
/// other as the terms of one do.
inline void invert_positive(std::vector<double>& m, std::size_t n) {
  thread_local std::vector<double> column, out;
  // m = L Lᵀ; L⁻¹ takes L's place; then m⁻¹ = L⁻ᵀ L⁻¹.
  column.resize(n);
  for (std::size_t j = 0; j < n; ++j) {
    m[j * n + j] = std::sqrt(m[j * n + j]);
    for (std::size_t i = j + 1; i < n; ++i) {
      const double from = column[i] = m[i * n + j] /= m[j * n + j];
      for (std::size_t k = j + 1; k <= i; ++k) m[i * n + k] -= from * column[k];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::fill_n(column.begin(), i, 0.0);
    for (std::size_t j = 0; j < i; ++j) {
      const double from = m[i * n + j];
      for (std::size_t k = 0; k <= j; ++k) column[k] -= from * m[j * n + k];
    }
    const double own = m[i * n + i];
    for (std::size_t k = 0; k < i; ++k) m[i * n + k] = column[k] / own;
    m[i * n + i] = 1 / own;
  }
  out.assign(n * n, 0);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      const double from = m[j * n + i];
      for (std::size_t k = i; k <= j; ++k) out[i * n + k] += from * m[j * n + k];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i; k < n; ++k) m[i * n + k] = m[k * n + i] = out[i * n + k];
  }
}

/// Solves m x = b by elimination with pivots; x takes b's place, m is lost.
inline void solve_linear(std::vector<double>& m, std::vector<double>& b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < n; ++k) {
      if (std::abs(m[k * n + i]) > std::abs(m[pivot * n + i])) pivot = k;
    }
    for (std::size_t j = 0; j < n; ++j) std::swap(m[i * n + j], m[pivot * n + j]);
    std::swap(b[i], b[pivot]);
    for (std::size_t k = i + 1; k < n; ++k) {
      const double part = m[k * n + i] / m[i * n + i];
      for (std::size_t j = i; j < n; ++j) m[k * n + j] -= part * m[i * n + j];
      b[k] -= part * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= m[i * n + j] * b[j];
    b[i] /= m[i * n + i];
  }
}

}  // namespace stig::physics
