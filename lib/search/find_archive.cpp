// SPDX-License-Identifier: MIT
#include "search/find_archive.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/hash.h"

namespace stig::search {

bool FindArchive::better(std::size_t a, std::size_t b) const {
  if (kept_[a].score != kept_[b].score) return kept_[a].score > kept_[b].score;
  return kept_[a].id < kept_[b].id;
}

std::uint64_t FindArchive::cell_of(const Individual& individual) const {
  std::uint64_t cell = 0;
  for (const GridAxis& axis : axes_) {
    const double share = (individual.values[axis.objective] - axis.from) / (axis.to - axis.from);
    const double bin = std::clamp(share * axis.bins, 0.0, axis.bins - 1.0);
    cell = cell * static_cast<std::uint64_t>(axis.bins) + static_cast<std::uint64_t>(bin);
  }
  return cell;
}

bool FindArchive::offer(Individual individual) {
  assert(kept_.empty() || kept_.back().id < individual.id);
  ++times_[individual.structure];
  const auto known = champion_.find(individual.structure);
  if (known != champion_.end() && !(individual.score > kept_[known->second].score)) return false;
  const std::size_t place = kept_.size();
  const std::uint64_t structure = individual.structure, cell = cell_of(individual);
  kept_.push_back(std::move(individual));
  champion_[structure] = place;
  const auto [elite, first] = elite_.emplace(cell, place);
  if (!first && better(place, elite->second)) elite->second = place;
  return true;
}

std::vector<std::size_t> FindArchive::best(std::size_t most) const {
  std::vector<std::size_t> places;
  for (const auto& [structure, place] : champion_) places.push_back(place);
  const std::size_t count = std::min(most, places.size());
  std::partial_sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count),
                    places.end(), [&](std::size_t a, std::size_t b) { return better(a, b); });
  places.resize(count);
  return places;
}

std::vector<std::size_t> FindArchive::elites() const {
  std::vector<std::size_t> places;
  for (const auto& [cell, place] : elite_) places.push_back(place);
  return places;
}

std::uint64_t FindArchive::content_hash() const {
  std::uint64_t h = hash_text("archive 1");
  for (const Individual& i : kept_) {
    h = combine(combine(combine(h, i.id), std::bit_cast<std::uint64_t>(i.score)), i.structure);
  }
  for (const auto& [structure, times] : times_) h = combine(combine(h, structure), times);
  return h;
}

}  // namespace stig::search
