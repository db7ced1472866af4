// SPDX-License-Identifier: MIT
// All structures that robots can bring about, walked one by one: for small ones, whose decisions
// need no order of bricks.
#include <map>
#include <set>

#include "recheck/work_site.h"

namespace stig::recheck {

namespace {

/// As deep in its lane as a robot goes.
struct Stand {
  int side = 0;
  Seen at;
  auto operator<=>(const Stand&) const = default;
};

/// What may be so in a structure, on any way to it.
struct Met {
  std::set<Deed> decided;  ///< and not done yet
  std::set<Stand> stands;
};

class Walk {
 public:
  Walk(WorkSite& site, WorkReport& report) : site_(site), whole_(site.whole), report_(report) {}

  std::string check() {
    now_.emplace(whole_.start(), Met{});
    // Each brick put leads to structures with one more.
    while (!now_.empty() && refusal_.empty()) {
      for (auto& [state, met] : now_) visit(state, met);
      now_ = std::move(next_);
      next_.clear();
    }
    return refusal_;
  }

 private:
  void refuse(const std::string& why) {
    if (refusal_.empty()) refusal_ = why;
  }

  void visit(const Bricks& state, Met& met) {
    if (!refusal_.empty()) return;
    if (++report_.structures > kMostWalkedWork) return refuse("too many structures to walk");
    bool something = false;
    for (const int side : site_.certificate.sides) {
      for (const Before& at : foremost(state, side)) something = look(state, at, met) || something;
    }
    if (!something && !whole(state)) return refuse("nothing is left to be done before the end");
    for (const Deed& deed : met.decided) put(state, met, deed);
  }

  bool whole(const Bricks& state) const {
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      if (!state.has(i)) return false;
    }
    return true;
  }

  /// Columns to which robots come: next to what stands before them is one cell at most.
  std::vector<Before> foremost(const Bricks& state, int side) const {
    std::map<int, int> ends;
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      if (!state.has(i)) continue;
      const Seen at = whole_.seen(side, i);
      const auto [row, added] = ends.emplace(at.v, at.u);
      if (!added && at.u > row->second) row->second = at.u;
    }
    std::vector<Before> out;
    for (const auto& [v, u] : ends) {
      const auto left = ends.find(v + 1), right = ends.find(v - 1);
      if (left != ends.end() && left->second > u + 1) continue;
      if (right != ends.end() && right->second > u + 1) continue;
      out.push_back({side, u, v});
    }
    return out;
  }

  /// Is something to be done there?
  bool look(const Bricks& state, const Before& at, Met& met) {
    ++report_.situations;
    for (const int u : {at.u, at.u + 1}) {
      const Seen place{u, at.v, 0};
      if (site_.room.lane(at.side, place).meets(state)) continue;
      met.stands.insert({at.side, place});
      break;
    }
    const auto wish = site_.wish(at, state);
    if (!wish) return false;
    std::string why;
    const std::uint32_t brick = site_.meant(at, *wish, {state, state}, why);
    if (brick == kNoBrick) {
      refuse(why);
      return false;
    }
    met.decided.insert({brick, at.side});
    Seen place = whole_.seen(at.side, brick);
    place.z = 0;
    met.stands.insert({at.side, place});
    return true;
  }

  void put(const Bricks& state, const Met& met, const Deed& deed) {
    Bricks after = state;
    after.add(deed.brick);
    Met& next = next_[after];
    const WorkCrowd crowd = site_.certificate.crowd;
    if (crowd == WorkCrowd::one) return;  // it comes back with nothing decided
    // So does the one of a side, which others share then not.
    const auto is_the_same = [&](int side) {
      return crowd == WorkCrowd::one_a_side && side == deed.side;
    };
    for (const Deed& other : met.decided) {
      if (other.brick == deed.brick || is_the_same(other.side)) continue;
      if (const std::string why = site_.fault(other, {after, after}); !why.empty()) {
        return refuse("when others have put theirs, " + why);
      }
      next.decided.insert(other);
    }
    for (const Stand& stand : met.stands) {
      if (is_the_same(stand.side)) continue;
      const Seen brick = whole_.seen(stand.side, deed.brick);
      if (!site_.room.in_lane(stand.at, brick)) {
        next.stands.insert(stand);
      } else if (site_.room.behind(stand.at, brick)) {
        return refuse(site_.name(deed.brick) + " may shut a robot in");
      }
    }
  }

  WorkSite& site_;
  const Whole& whole_;
  WorkReport& report_;
  std::map<Bricks, Met> now_, next_;
  std::string refusal_;
};

}  // namespace

std::string check_walked(WorkSite& site, WorkReport& report) { return Walk(site, report).check(); }

}  // namespace stig::recheck
