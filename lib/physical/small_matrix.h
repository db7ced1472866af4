// SPDX-License-Identifier: MIT
// Dense matrices of a mechanism's size, row by row in a vector.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stig {

/// The inverse of a positive definite matrix of which the lower half is given, in place.
inline void invert_positive(std::vector<double>& m, std::size_t n) {
  // m = L Lᵀ; L⁻¹ takes L's place; then m⁻¹ = L⁻ᵀ L⁻¹.
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = m[i * n + k];
      for (std::size_t j = 0; j < k; ++j) sum -= m[i * n + j] * m[k * n + j];
      m[i * n + k] = i == k ? std::sqrt(sum) : sum / m[k * n + k];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      double sum = 0;
      for (std::size_t j = k; j < i; ++j) sum -= m[i * n + j] * m[j * n + k];
      m[i * n + k] = sum / m[i * n + i];
    }
    m[i * n + i] = 1 / m[i * n + i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i; k < n; ++k) {
      double sum = 0;
      for (std::size_t j = k; j < n; ++j) sum += m[j * n + i] * m[j * n + k];
      m[i * n + k] = sum;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) m[i * n + k] = m[k * n + i];
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

}  // namespace stig
