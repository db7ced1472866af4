// SPDX-License-Identifier: MIT
// What an MCAP file says, read without the code that writes it. A test fails where the file breaks
// the format: records, lengths, CRCs, indices and statistics are held to what is there.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace stig {

struct McapContent {
  struct Message {
    std::string topic;
    std::uint64_t time = 0;  ///< ns
    nlohmann::json content;
  };
  std::map<std::string, std::string> schemas;  ///< of each topic, the name
  std::map<std::string, std::string> facts;    ///< of the metadata "run"
  std::vector<Message> messages;
  std::size_t chunks = 0;

  std::vector<Message> of(const std::string& topic) const;
};

McapContent mcap_content(const std::string& bytes);

}  // namespace stig
