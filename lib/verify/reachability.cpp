// SPDX-License-Identifier: MIT
// Condition for agents that walk: a site that is due must be connected to the outside by
// empty cells. The sufficient test works on the certificate alone: bricks that are always
// placed later than q are empty while q is due, so a path of such bricks to the outside is
// a way in. Where that fails, the greatest structure without q is built and flooded; if q
// is cut off there, this is a counterexample with an order of events. The rest is counted
// as undecided.
//
// The flood fill covers the bounding box of the structure and a margin of one cell:
// O(volume) time and one bit per cell.
#include "verify/reachability.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <vector>

#include "lattice/cell_map.h"
#include "verify/stage_run.h"

namespace stig::verify {
namespace {

/// 64 million cells are 8 MB of bits for each flood fill.
constexpr std::int64_t kMostCells = std::int64_t{1} << 26;  ///< of the region looked at
constexpr std::size_t kMostSitesTried = 24;
constexpr std::uint64_t kAttemptWork = 2'000'000'000;  ///< steps

/// The bounding box of a structure and one cell more to every side, as far as agents get.
class Region {
 public:
  Region(const CellBounds& bounds, const std::optional<Box>& box, bool floor) {
    low_ = bounds.low + Offset{-1, -1, -1};
    high_ = bounds.high + Offset{1, 1, 1};
    // Agents do not walk below the floor or outside the box.
    if (floor) low_.z = std::max(low_.z, 0);
    if (box) {
      low_ = {std::max(low_.x, box->low.x), std::max(low_.y, box->low.y),
              std::max(low_.z, box->low.z)};
      const Cell top = box->low + box->size + Offset{-1, -1, -1};
      high_ = {std::min(high_.x, top.x), std::min(high_.y, top.y), std::min(high_.z, top.z)};
    }
    bounds_ = bounds;
  }
  std::int64_t cells() const {
    const Offset s = high_ - low_ + Offset{1, 1, 1};
    return std::int64_t{s.x} * s.y * s.z;
  }
  bool contains(Cell c) const {
    return c.x >= low_.x && c.y >= low_.y && c.z >= low_.z && c.x <= high_.x && c.y <= high_.y &&
           c.z <= high_.z;
  }
  /// Outside the structure's bounding box: there is nothing there but air.
  bool is_margin(Cell c) const {
    return c.x < bounds_.low.x || c.y < bounds_.low.y || c.z < bounds_.low.z ||
           c.x > bounds_.high.x || c.y > bounds_.high.y || c.z > bounds_.high.z;
  }
  std::size_t index(Cell c) const {
    assert(contains(c));
    const Offset s = high_ - low_ + Offset{1, 1, 1}, o = c - low_;
    return (static_cast<std::size_t>(o.z) * static_cast<std::size_t>(s.y) +
            static_cast<std::size_t>(o.y)) *
               static_cast<std::size_t>(s.x) +
           static_cast<std::size_t>(o.x);
  }
  template <class Visit>
  void for_each_margin_cell(const Visit& visit) const {
    for (std::int32_t z = low_.z; z <= high_.z; ++z) {
      for (std::int32_t y = low_.y; y <= high_.y; ++y) {
        for (std::int32_t x = low_.x; x <= high_.x; ++x) {
          const Cell c{x, y, z};
          if (is_margin(c)) visit(c);
        }
      }
    }
  }

 private:
  Cell low_, high_;
  CellBounds bounds_;
};

/// The empty cells of the region that agents from outside can walk to. Breadth or depth
/// first does not matter for a set; a stack keeps memory small.
std::vector<bool> outside(const Structure& structure, const Region& region) {
  const Neighbourhood& n = neighbourhood(structure.lattice());
  std::vector<bool> reached(static_cast<std::size_t>(region.cells()), false);
  std::vector<Cell> todo;
  const auto reach = [&](Cell c) {
    if (!region.contains(c) || reached[region.index(c)] || structure.at(c) != kEmpty) return;
    reached[region.index(c)] = true;
    todo.push_back(c);
  };
  region.for_each_margin_cell(reach);
  while (!todo.empty()) {
    const Cell c = todo.back();
    todo.pop_back();
    for (int i = 0; i < n.size; ++i) reach(c + n.offsets[static_cast<std::size_t>(i)]);
  }
  return reached;
}

/// The bricks of all stages in the order of the run, with what is before each. Numbers run
/// on over all stages, as do those of the run, so that a later stage's bricks are after all
/// earlier ones.
struct Work {
  std::vector<CertifiedBrick> bricks;
  std::vector<int> stage;
  CellMap<std::uint32_t> number{~std::uint32_t{0}};
};

Work work_of(const Certificate& certificate) {
  Work work;
  int stage = 1;
  for (const CertifiedStage& s : certificate.stages) {
    for (const CertifiedBrick& brick : s.order) {
      work.number[brick.at] = static_cast<std::uint32_t>(work.bricks.size());
      work.bricks.push_back(brick);
      work.stage.push_back(stage);
    }
    ++stage;
  }
  return work;
}

class Reachability {
 public:
  Reachability(const RuleSet& rules, const VerifyOptions& options, const VerifyResult& result,
               const Budget& budget)
      : rules_(rules),
        options_(options),
        budget_(budget),
        n_(neighbourhood(rules.lattice)),
        structure_(*result.structure),
        run_(result.run),
        region_(*structure_.bounds(), options.box, rules.floor),
        work_(work_of(*result.certificate)) {
    assert(run_.size() == work_.bricks.size());
  }

  void find(Findings& findings) {
    // A periodic box has no outside.
    if (region_.cells() > kMostCells || (options_.box && options_.box->periodic)) return;
    const std::vector<bool> free = outside(structure_, region_);
    if (std::find(free.begin(), free.end(), true) == free.end()) return;  // the box is full
    std::vector<bool> open(work_.bricks.size(), false);
    std::vector<std::uint32_t> doubtful;
    // From the last brick to the first: is_after leads from a brick to later ones only, so
    // their answer is known.
    for (std::uint32_t b = static_cast<std::uint32_t>(work_.bricks.size()); b-- > 0;) {
      open[b] = has_way_out(b, free, open);
      if (!open[b]) doubtful.push_back(b);
    }
    std::reverse(doubtful.begin(), doubtful.end());
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      const bool tried = k < kMostSitesTried && findings.walled_in.size() < kMostWalledIn;
      if (tried && wall_in(doubtful[k], findings)) continue;
      ++findings.maybe_walled_in;
    }
  }

 private:
  bool has_way_out(std::uint32_t b, const std::vector<bool>& free,
                   const std::vector<bool>& open) const {
    for (int i = 0; i < n_.size; ++i) {
      const Cell beside = work_.bricks[b].at + n_.offsets[static_cast<std::size_t>(i)];
      if (!region_.contains(beside)) continue;
      if (structure_.at(beside) == kEmpty) {
        if (free[region_.index(beside)]) return true;
        continue;
      }
      const std::uint32_t other = work_.number.at(beside);
      if (other < work_.bricks.size() && open[other] && is_after(other, b, i)) return true;
    }
    return false;
  }
  /// Is `other`, neighbour i of b, always after b?
  bool is_after(std::uint32_t other, std::uint32_t b, int i) const {
    if (work_.stage[other] != work_.stage[b]) return work_.stage[other] > work_.stage[b];
    return (work_.bricks[other].before >> n_.opposite(i) & 1U) != 0;
  }

  /// Builds all that can be built without this brick, and looks whether it is cut off. The
  /// greatest structure without q encloses it most tightly, so it is the one that is tried.
  /// If q is reachable there, nothing is proved, and the site counts as undecided.
  bool wall_in(std::uint32_t b, Findings& findings) const {
    const RuleTable table(rules_);
    if (budget_.spent()) return false;
    std::uint64_t done = 0;
    Budget attempt = budget_;
    attempt.work = std::min(kAttemptWork, budget_.work_left());
    attempt.done = &done;
    LatticeWorld world(table, rules_.start, options_.box);
    std::vector<Deposit> order;
    // Earlier stages are taken from the run: in a proved set all orders agree on where they
    // end.
    for (std::uint32_t i = 0; i < run_.size() && work_.stage[i] < work_.stage[b]; ++i) {
      world.deposit(run_[i].site, run_[i].colour, [](Cell, const View&) {});
      order.push_back(run_[i]);
    }
    while (world.stage() < work_.stage[b] && world.next_stage()) {
    }
    const Cell site = work_.bricks[b].at;
    StageRunConfig config;
    config.may_fill = [&](Cell cell) { return cell != site; };
    attempt.spend(order.size() * kStepsOfDeposit);
    const StageRun run = run_stage(world, config, attempt);
    budget_.spend(done);
    order.insert(order.end(), run.deposits.begin(), run.deposits.end());
    for (std::size_t i = 0; i < order.size(); ++i) order[i].step = i + 1;
    // If the site is not open in that structure, no agent is sent there then, and being cut
    // off is no harm.
    if (!world.is_site(site) || !table.enabled(world.view(site), site.z, world.stage())) {
      return false;
    }
    if (outside(world.structure(), region_)[region_.index(site)]) return false;
    findings.walled_in.push_back({site, std::move(order)});
    return true;
  }

  const RuleSet& rules_;
  const VerifyOptions& options_;
  const Budget& budget_;
  const Neighbourhood& n_;
  const Structure& structure_;
  const std::vector<Deposit>& run_;
  Region region_;
  Work work_;
};

}  // namespace

void find_walled_in(const RuleSet& rules, const VerifyOptions& options, const VerifyResult& result,
                    const Budget& budget, Findings& findings) {
  assert(result.verdict == ProofVerdict::proved);
  if (result.structure->empty()) return;
  Reachability(rules, options, result, budget).find(findings);
}

}  // namespace stig::verify
