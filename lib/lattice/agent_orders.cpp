// SPDX-License-Identifier: MIT
#include "lattice/agent_orders.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stig::lattice {
namespace {

/// Numbers coprime to `count`: all below it, or 4096 spread over the range where it is
/// large. A stride coprime to the number of agents visits each agent once, so an order is
/// two numbers and not a permutation. 4096 strides are random enough, and all of them would
/// be a long list for a million agents.
std::vector<std::uint32_t> coprimes(std::uint32_t count) {
  constexpr std::uint32_t kEnough = 4096;
  if (count == 1) return {0};
  const std::uint32_t stride = std::max(1U, count / kEnough);
  std::vector<std::uint32_t> all;
  for (std::uint32_t from = 1; from < count; from += stride) {
    std::uint32_t i = from;
    while (i < from + stride && std::gcd(i, count) != 1) ++i;
    if (i < from + stride && i < count) all.push_back(i);
  }
  return all;
}

/// By Euclid's algorithm, for coprime numbers.
std::uint64_t inverse(std::uint32_t number, std::uint32_t modulus) {
  std::int64_t rest = modulus, last = number, factor = 0, last_factor = 1;
  while (last > 1) {
    const std::int64_t quotient = rest / last;
    rest = std::exchange(last, rest - quotient * last);
    factor = std::exchange(last_factor, factor - quotient * last_factor);
  }
  return static_cast<std::uint64_t>(last_factor < 0 ? last_factor + modulus : last_factor);
}

}  // namespace

AgentOrders::AgentOrders(std::uint64_t seed, std::uint32_t run, std::uint32_t agents)
    : seed_(seed), run_(run), agents_(agents), strides_(coprimes(agents)) {}

WalkOrder AgentOrders::of_step(std::uint64_t step) {
  // Four words of one Philox block serve the orders of two steps.
  if (step / 2 != block_) {
    block_ = step / 2;
    words_ = philox(random_address(run_, Purpose::order, 0, block_), random_key(seed_));
  }
  const std::size_t half = step % 2 * 2;
  const auto below = [](std::uint32_t word, std::size_t bound) {
    return static_cast<std::uint32_t>((std::uint64_t{word} * bound) >> 32);
  };
  WalkOrder order;
  order.count = agents_;
  order.base = below(words_[half], agents_);
  order.stride = strides_[below(words_[half + 1], strides_.size())];
  return order;
}

std::uint32_t place_in(const WalkOrder& order, std::uint32_t agent) {
  if (order.count == 1) return 0;
  const std::uint64_t from_base = (std::uint64_t{agent} + order.count - order.base) % order.count;
  return static_cast<std::uint32_t>(from_base * inverse(order.stride, order.count) % order.count);
}

std::uint32_t agent_at(const WalkOrder& order, std::uint32_t place) {
  return static_cast<std::uint32_t>((order.base + std::uint64_t{place} * order.stride) %
                                    order.count);
}

}  // namespace stig::lattice
