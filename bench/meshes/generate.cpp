// Writes a structure of 8-node bricks as a finite-element code would: matrices, dof table, node coordinates, model.
#include "meshes/bricks.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

using namespace gyromode;
using namespace gyromode::bench;

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open(const std::filesystem::path& path) {
  File f(std::fopen(path.c_str(), "w"), &std::fclose);
  if (!f) throw std::runtime_error("cannot write " + path.string());
  return f;
}

// Upper triangle, column by column, as CalculiX stores it.
void write(const SparseMatrix& lower, const std::filesystem::path& path) {
  const File f = open(path);
  const SparseMatrix upper = lower.transpose();
  for (Index j = 0; j < upper.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(upper, j); it; ++it) fmt::print(f.get(), "{} {} {:.17g}\n", it.row() + 1, j + 1, it.value());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes a structure of 8-node bricks (steel, SI units) into a folder: M, K, dof table, node coordinates, model.toml"};
  std::string kind = "cantilever", folder;
  std::vector<int> bricks{4, 4, 20};
  std::vector<double> size{0.1, 0.104, 1.0};
  double spin = 100, twist = 0, lean = 0;
  int blades = 4, fine = 1;
  app.add_option("KIND", kind, "cantilever, shaft (free, under the stress of its spin) or disc (with blades)")
      ->required()
      ->check(CLI::IsMember({"cantilever", "shaft", "disc"}));
  app.add_option("-o", folder, "folder to write to")->required();
  app.add_option("--bricks", bricks, "of a cantilever or shaft, along x, y, z")->expected(3);
  app.add_option("--size", size, "of it, m")->expected(3);
  app.add_option("--blades", blades, "of a disc");
  app.add_option("--fine", fine, "bricks across a thickness of a disc, halved");
  app.add_option("--twist", twist, "of its blades from root to tip, rad");
  app.add_option("--lean", lean, "of its blades, m: no symmetry is left");
  app.add_option("--spin", spin, "about z, rad/s");
  bool stressed = false, rest = false;
  app.add_flag("--stress", stressed, "K with the stress of the spin, as that of a shaft always is");
  app.add_flag("--rest", rest, "K at rest, too, so that the spin can be varied");
  CLI11_PARSE(app, argc, argv);
  const BrickMesh mesh = kind == "disc" ? bladed_disc(blades, fine, twist, lean)
                                        : box({size[0], size[1], size[2]}, {bricks[0], bricks[1], bricks[2]}, kind == "cantilever");
  const StructureParts p =
      assembled_bricks(mesh, {}, spin, kind == "shaft" || stressed ? displacement_under_spin(mesh, {}, spin) : Vector());
  std::filesystem::create_directories(folder);
  const std::filesystem::path to = folder;
  write(p.mass, to / "model.mas");
  write(p.stiffness, to / "model.sti");
  if (rest) write(assembled_bricks(mesh, {}, 0).stiffness, to / "rest.sti");
  const File dof = open(to / "model.dof"), csv = open(to / "nodes.csv"), toml = open(to / "model.toml");
  for (const MeshCoordinate& c : p.coordinates) fmt::print(dof.get(), "{}.{}\n", c.node, c.direction + 1);
  fmt::print(csv.get(), "node,x,y,z\n");
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    fmt::print(csv.get(), "{},{:.17g},{:.17g},{:.17g}\n", n + 1, mesh.nodes[n][0], mesh.nodes[n][1], mesh.nodes[n][2]);
  fmt::print(toml.get(),
             "kind = \"structure\"\ntitle = \"{} of {} bricks\"\nmass = \"model.mas\"\nstiffness = \"model.sti\"\ndofs = \"model.dof\"\n"
             "coordinates = \"nodes.csv\"\nspin = {:.17g}\naxis = [0, 0, 1]\n",
             kind, mesh.bricks.size(), spin);
  if (rest) fmt::print(toml.get(), "stiffness_at_rest = \"rest.sti\"\n");
  fmt::print("{} coordinates, {} + {} entries\n", p.mass.cols(), p.mass.nonZeros(), p.stiffness.nonZeros());
}
