#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "idiophone/instruments/resonators/damped_oscillator.hpp"
#include "idiophone/instruments/sound_maps/exports.hpp"

namespace idiophone::sound_maps {

namespace {

/// What is the same for all maps: z' = x z + F for each mode, x = i w - d, exact for a force that is linear between
/// samples; its output is the real part of g (z + F/x + F'/x^2), which is silent for a slow force
/// (resonators::DampedOscillator::rising_state()). Modes that the sampling rate cannot hold are silent.
constexpr const char* mode_definition = R"(
import("stdfaust.lib");

friction = hslider("friction[tooltip: times the decay of material and supports]", 1, 0, 20, 0.01);
T = 1.0/ma.SR;
// f: damped frequency, Hz; dm, dr: decay by the material and by the radiation, 1/s; gr, gi: pressure for z = 1
mode(f, dm, dr, gr, gi, force, rise) = ((force : (step ~ (_, _)) : sound) + byForce*force + byRise*rise) * (f < ma.SR/2)
with {
  w = 2*ma.PI*f;
  d = dm*friction + dr;
  er = exp(-d*T)*cos(w*T);             // e: exp(x T)
  ei = exp(-d*T)*sin(w*T);
  n = d*d + w*w;
  sr = ((er - 1)*(-d) + ei*w)/n;       // s = (e - 1)/x
  si = (ei*(-d) - (er - 1)*w)/n;
  br = ((sr - T)*(-d) + si*w)/(n*T);   // b = (s - T)/(x T): weight of the force now
  bi = (si*(-d) - (sr - T)*w)/(n*T);
  step(x, y, F) = er*x - ei*y + br*F + (sr - br)*F', ei*x + er*y + bi*F + (si - bi)*F';
  sound(x, y) = gr*x - gi*y;
  byForce = (gi*w - gr*d)/n;           // the real part of g/x
  byRise = (gr*(d*d - w*w) - 2*gi*d*w)/(n*n);  // the real part of g/x^2
};
// How fast the force rises, N/s, after a low-pass of the angular frequency c.
rise(c, force) = c*(force - smooth)
with {
  e = exp(-c*T);
  s = (1 - e)/c;
  b = (T - s)/(c*T);
  smooth = c*(b*force + (s - b)*force') : + ~ *(e);
};
)";

/// Text that Faust takes as one string.
std::string quoted(const std::string& text) {
  std::string plain = text;
  std::ranges::replace(plain, '"', '\'');
  return '"' + plain + '"';
}

}  // namespace

std::string faust_program(const sound_maps::SoundMap& map, std::span<const double> participation, std::size_t listener,
                          const std::string& place) {
  const sound_maps::MapListener& ear = map.listeners[listener];
  std::string program = fmt::format(
      "// Body {} of the deck {}, struck {}, heard at {}.\n"
      "// Input: force, N. Output: pressure, Pa, without the {:.6g} s that sound takes to the listener.\n"
      "// Compile it with -double: slow decays need the digits.\n"
      "declare name {};\ndeclare version \"idiophone {}\";\n",
      map.body, map.name, place, ear.name, ear.delay, quoted(map.name + " " + map.body), map.code_version);
  program += mode_definition;
  double lowest = 0.0;  // rad/s
  std::string modes, separator = "  ";
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    const resonators::DampedOscillator oscillator(map.frequency[mode], map.decay(mode));
    if (!oscillator.oscillates()) {
      continue;
    }
    const std::complex<double> gain = participation[mode] * ear.pressure[mode] * oscillator.velocity();
    lowest = lowest == 0.0 ? oscillator.damped : lowest;
    modes += fmt::format("{}mode({:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g})", separator,
                         oscillator.damped / (2.0 * std::numbers::pi), map.material_decay[mode],
                         map.radiation_decay[mode], gain.real(), gain.imag());
    separator = ",\n  ";
  }
  return program + fmt::format("\nprocess = _ <: _, rise({:.17g}) <:\n{}\n  :> _;\n", lowest, modes);
}

}  // namespace idiophone::sound_maps
