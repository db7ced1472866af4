// SPDX-License-Identifier: MIT
#include "certify/changes.h"
#include "support/uses.h"

#include <rapidcheck.h>

#include <algorithm>

namespace stig {
namespace {

int number(int low, int high) { return *rc::gen::resize(100, rc::gen::inRange(low, high + 1)); }

template <class T>
T& any_of(std::vector<T>& list) {
  return list[static_cast<std::size_t>(number(0, static_cast<int>(list.size()) - 1))];
}

void insert_filling(CertifiedWindow& window, const Filling& filling) {
  const auto less = [](const Filling& a, const Filling& b) {
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  };
  const auto at = std::lower_bound(window.fillings.begin(), window.fillings.end(), filling, less);
  if (at == window.fillings.end() || *at != filling) window.fillings.insert(at, filling);
}

void change_window(CertifiedWindow& window) {
  const std::size_t bits = window.group.size() + window.context.size();
  switch (number(0, 2)) {
    case 0:
      window.fillings.erase(window.fillings.begin() +
                            number(0, static_cast<int>(window.fillings.size()) - 1));
      break;
    case 1: {
      Filling filling = any_of(window.fillings);
      const int bit = number(0, static_cast<int>(bits) - 1);
      filling[static_cast<std::size_t>(bit) / 64] ^= std::uint64_t{1} << bit % 64;
      insert_filling(window, filling);
      break;
    }
    default:
      if (window.group.size() > 1) {
        window.context.insert(window.context.begin(), window.group.back());
        window.group.pop_back();
      }
  }
}

}  // namespace

void change_somewhere(Certificate& certificate) {
  CertifiedStage& stage = any_of(certificate.stages);
  if (stage.order.empty()) {
    certificate.bricks += 1;
    return;
  }
  switch (number(0, 6)) {
    case 0:
      any_of(stage.order).before ^= 1U << number(0, kMaxNeighbours - 1);
      break;
    case 1:
      for (CertifiedBrick& brick : stage.order) brick.before = 0;
      stage.far.clear();
      break;
    case 2:
      any_of(stage.order).colour = static_cast<Colour>(number(1, 3));
      break;
    case 3: {
      Cell& cell = any_of(stage.order).at;
      cell = cell + Offset{number(-1, 1), number(-1, 1), number(-1, 1)};
      break;
    }
    case 4:
      std::swap(any_of(stage.order), any_of(stage.order));
      break;
    case 5:
      stage.order.pop_back();
      certificate.bricks -= 1;
      break;
    default:
      if (stage.windows.empty()) {
        stage.far.push_back({0, number(0, 1) == 0 ? 0U : 1U});
      } else {
        change_window(any_of(stage.windows));
      }
  }
}

}  // namespace stig
