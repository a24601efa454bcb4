// Proxy files: the same lattices come back to the bit; what is foreign or damaged is refused.

#include "idiophone/instruments/proxies/proxy_file.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "idiophone/foundation/flat_file.hpp"
#include "idiophone/instruments/proxies/engine.hpp"

namespace idiophone::proxies {
namespace {

/// Pinned, with values of their own for tetrahedra, masses and a spring, under tension.
std::shared_ptr<const Lattice> tense_beam() {
  TetrahedralMesh mesh = box({0.3, 0.1, 0.1}, {3, 1, 1}, 0.0);
  OwnValues own;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const double part = static_cast<double>(t) / static_cast<double>(mesh.tetrahedra.size());
    own.stiffness.push_back(1.0 + part);
    own.damping.push_back(2.0 - part);
    own.length.push_back(1.0 - 0.02 * part);
    own.edges.push_back({1.0, 1.1, 1.0, 0.9, 1.0, 1.0 + part});
  }
  own.masses.assign(mesh.nodes.size(), 0.02);
  own.springs = {{.a = mesh.tetrahedra[0][0], .b = mesh.tetrahedra[0][1], .stiffness = 1.5, .length = 0.99}};
  const std::vector<Index> pinned = {mesh.surface[0][0], mesh.surface[0][1], mesh.surface[0][2]};
  return std::make_shared<Lattice>(std::move(mesh), rubber, pinned, std::move(own));
}

StoredBody again(const StoredBody& body) {
  return read_proxy(proxy_file(body), "body.proxy");
}

std::vector<double> struck(const StoredBody& body) {
  Engine engine({.rate = 8000});
  engine.add({.name = body.name, .levels = body.levels});
  engine.add(impact(0, 10, {0.05, 0.1, 0.02}, {0, -0.01, 0.003}, 5e-4, 8000));
  std::vector<double> sound(2000);
  engine.render(sound);
  return sound;
}

/// @return what is said; empty if it is read
std::string refusal_of(const std::string& bytes) {
  try {
    static_cast<void>(read_proxy(bytes, "body.proxy"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string with_right_checksum(std::string bytes) {
  const std::uint64_t right = flat_checksum(std::span(bytes).subspan(28));
  for (std::size_t i = 0; i < sizeof(right); ++i) {
    bytes[20 + i] = static_cast<char>(right >> (8U * i));
  }
  return bytes;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ProxyFile, SoundsTheSameToTheBit) {
  for (const StoredBody& body :
       {StoredBody{"cube", {rubber_cube(3), rubber_cube(2)}}, StoredBody{"beam", {tense_beam()}}}) {
    const StoredBody read = again(body);
    EXPECT_EQ(read.name, body.name);
    ASSERT_EQ(read.levels.size(), body.levels.size());
    EXPECT_NE(struck(body), std::vector<double>(2000));
    EXPECT_EQ(struck(read), struck(body)) << body.name;
    EXPECT_EQ(proxy_file(read), proxy_file(body)) << body.name;
    EXPECT_EQ(read.levels.back()->mesh().nodes, body.levels.back()->mesh().nodes);
    EXPECT_EQ(read.levels.back()->masses(), body.levels.back()->masses());
    EXPECT_EQ(read.levels.back()->pinned(), body.levels.back()->pinned());
  }
}

/// The format does not depend on the machine, and files stay readable.
TEST(ProxyFile, BeginsWithItsNameAndVersion) {
  const std::string bytes = proxy_file({"cube", {rubber_cube(2)}});
  EXPECT_EQ(bytes.substr(0, 20), std::string("IDIOPHONE PROXY\n\1\0\0\0", 20));
  EXPECT_EQ(bytes.substr(28, 20), std::string("\4\0\0\0\0\0\0\0cube\1\0\0\0\0\0\0\0", 20));
}

TEST(ProxyFile, RefusesWhatIsForeignOrDamaged) {
  const std::string bytes = proxy_file({"cube", {rubber_cube(2)}});
  EXPECT_TRUE(says(refusal_of(""), "body.proxy is no proxy file"));
  EXPECT_TRUE(says(refusal_of("IDIOPHONE VOICE\n and so on"), "it does not begin as one; `idiophone export DECK"));
  std::string newer = bytes, damaged = bytes;
  newer[16] = 2;
  EXPECT_TRUE(says(refusal_of(newer), "version 2, and this library reads version 1"));
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  EXPECT_TRUE(says(refusal_of(damaged), "its checksum is wrong"));
  for (std::size_t length = 0; length < bytes.size(); length += 97) {
    EXPECT_NE(refusal_of(bytes.substr(0, length)), "");
  }
}

/// The checksum is right, so that the contents are looked at.
TEST(ProxyFile, DoesNotBelieveItsContents) {
  const auto refused = [](const std::function<void(std::string&)>& change) {
    std::string bytes = proxy_file({"cube", {rubber_cube(2)}});
    change(bytes);
    return refusal_of(with_right_checksum(bytes));
  };
  constexpr std::size_t levels = 40, first_node = 56;
  const std::size_t nodes = rubber_cube(2)->mesh().nodes.size();
  EXPECT_EQ(refused([](std::string& /*bytes*/) {}), "");
  EXPECT_TRUE(says(refused([](std::string& bytes) { bytes[levels] = 7; }), "it has 7 levels"));
  EXPECT_TRUE(says(refused([](std::string& bytes) { bytes[levels] = 0; }), "it has 0 levels"));
  EXPECT_TRUE(says(refused([](std::string& bytes) { bytes[first_node + 7] = 0x7f; }), "a node is not finite"));
  EXPECT_TRUE(
      says(refused([&](std::string& bytes) { bytes[first_node + 24 * nodes + 8] = 100; }), "a node that there is not"));
  EXPECT_TRUE(says(refused([](std::string& bytes) { bytes += "more"; }), "something follows its end"));
  EXPECT_TRUE(says(refused([&](std::string& bytes) { bytes[first_node + 24 * nodes + 6] = 1; }), "it ends too early"));
}

}  // namespace
}  // namespace idiophone::proxies
