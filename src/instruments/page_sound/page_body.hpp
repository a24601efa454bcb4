#pragma once
// A body of the Sonic Explorer: its modes, and the forces and bows that act on them. The page calls it by exports.cpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/point_contacts.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "page_bow.hpp"

namespace idiophone::page_sound {

/// How the modes sound.
struct PageTuning {
  std::span<const double> frequency;  ///< [modes] Hz
  std::span<const double> decay;      ///< [modes] 1/s
  std::span<const double> pressure;   ///< [channels x modes x 2] real and imaginary part, Pa for 1 m sqrt(kg)/s
  double size = 1.0;                  ///< of the body over the size for which its stretching was computed
};

class PageBody {
 public:
  /// At rest and without a sound until tune() is called.
  /// @param channels    1 or 2
  /// @param rate        audio samples per second
  /// @param stretching  of the modes where their vibrations may be large
  PageBody(std::size_t modes, std::size_t channels, int rate,
           std::optional<resonators::StretchedModes> stretching = std::nullopt);

  /// What rings goes on. Modes from half the rate on, and those that only creep back, rest.
  void tune(const PageTuning& tuning);

  /// @param start  audio sample in which the force begins
  void strike(std::int64_t start, resonators::ForceCurve force, Participation participation);

  /// Puts a bow on the body. One too many, or on a body without a sound, does nothing.
  /// @param number  by which the page knows it for the next two; of no other bow on the body
  void put_bow(int number, const friction::Law& friction, const Participation& place);
  void lead_bow(int number, const resonators::ContactMotion& motion, Participation place);
  void lift_bow(int number);

  /// The next samples, [samples x channels] Pa without the delays to the listener.
  /// @param first  audio sample
  /// @return false if nothing sounds or acts: `sound` is left as it is then
  [[nodiscard]] bool render(std::int64_t first, std::span<double> sound);

  /// The largest rotation angle of the body's parts while they were stretched, root mean square, rad.
  [[nodiscard]] double largest_rotation() const { return bank_.largest_rotation(); }

 private:
  struct Force {
    std::int64_t start;
    resonators::ForceCurve curve;  // with its rise
    std::size_t acts_for;          // audio samples
    Participation participation;
    std::vector<resonators::ModeGroup> by_mean{}, by_slope{};
    std::array<resonators::ForcePiece, resonators::ResonatorBank::most_samples> piece{};  // of the present samples
  };

  /// phi times a number of each resonator.
  [[nodiscard]] std::vector<resonators::ModeGroup> driven(const Participation& participation,
                                                          resonators::Complex resonators::Resonator::*part) const;
  void tune(Force& force) const;
  [[nodiscard]] resonators::ContactPoint contact_point(const Participation& place) const;
  [[nodiscard]] std::vector<resonators::Drive> drives(std::int64_t first, std::size_t samples);
  void move_bows(std::int64_t samples);
  void end_bows();

  std::size_t channels_;
  int rate_;
  std::vector<resonators::Resonator> resonators_;  // [modes]
  std::vector<resonators::ModeGroup> gains_;       // [channels x groups]
  double lowest_ = 0.0;                            // frequency of the modes that sound, rad/s; 0: none does
  resonators::ResonatorBank bank_;
  std::list<Force> forces_;
  std::map<int, PageBow> bows_;
  resonators::PointContacts contacts_;
};

}  // namespace idiophone::page_sound
