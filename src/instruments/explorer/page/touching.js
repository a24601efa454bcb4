// Where falling bodies touch the ground and each other in a step.

/// Contacts of a step: `owner`, whose point touches `other` (null: the ground), the unit vector `normal` of the force on the owner, the
/// place, the share of the step before it touches, and the depth (m) by which it already was inside.
/// @param ground  height, m
/// @param skin    by which hulls are larger, m: so thin bodies are thick enough to touch
function findContacts(bodies, ground, skin, duration) {
  const contacts = [];
  for (const owner of bodies) {
    contacts.push(...fewest(onGround(owner, ground, duration)));
    for (const other of bodies) {
      if (other !== owner && areNear(owner, other, skin, duration)) contacts.push(...fewest(onBody(owner, other, skin, duration)));
    }
  }
  return contacts;
}

/// Whether the sphere around one body may meet the sphere and the half spaces of the other.
function areNear(owner, other, skin, duration) {
  const way = minus(owner.position, other.position), most = owner.reach + skin + duration * (owner.speed() + other.speed());
  if (lengthOf(way) > other.reach + most) return false;
  const at = other.inBody(way);
  return other.hull.planes.every(({normal, height}) => dot(normal, at) - height < most);
}

function onGround(owner, ground, duration) {
  const found = [], near = ground + duration * owner.speed() - owner.position[2];
  for (const point of owner.hull.points) {
    if (dot(owner.rows[2], point) > near) continue;
    const arm = applied(owner.rows, point), gap = owner.position[2] + arm[2] - ground, way = duration * owner.velocityAt(arm)[2];
    if (gap + Math.min(0, way) > 0) continue;
    found.push({owner, other: null, point, place: plus(owner.position, arm), normal: [0, 0, 1],
                moment: gap > 0 ? -gap / way : 0, depth: Math.max(0, -gap)});
  }
  return found;
}

function onBody(owner, other, skin, duration) {
  const found = [], between = minus(owner.position, other.position), spin = minus(owner.spin, other.spin);
  const drift = minus(minus(owner.velocity, other.velocity), cross(other.spin, between));
  // As the other body has them: where a point of the owner is, and its way in the step.
  const toOther = product(other.columns, owner.columns), offset = other.inBody(between);
  const turning = owner.columns.map(column => cross(scaled(spin, duration), column)), wayOf = product(other.columns, turning);
  const shift = scaled(other.inBody(drift), duration);
  const near = (other.reach + 2 * skin + duration * (owner.speed() + other.speed())) ** 2;
  for (const point of owner.hull.points) {
    const from = plus(offset, applied(toOther, point));
    const entry = dot(from, from) < near && other.hull.enter(from, plus(shift, applied(wayOf, point)), skin);
    if (!entry) continue;
    found.push({owner, other, point, place: owner.toRoom(point), normal: applied(other.rows, entry.normal),
                moment: Math.max(0, entry.share), depth: Math.max(0, -entry.share)});
  }
  return found;
}

/// Four of the contacts of two bodies hold them as well as all: the first, the farthest from it, and the farthest on both sides of
/// the line between these.
function fewest(contacts) {
  if (contacts.length <= 4) return contacts;
  const most = measure => contacts.reduce((best, contact) => measure(contact) > measure(best) ? contact : best);
  const first = most(({moment, depth}) => depth - moment);
  const away = ({place}) => minus(place, first.place), second = most(contact => lengthOf(away(contact)));
  const aside = contact => dot(cross(away(second), away(contact)), first.normal);
  return [...new Set([first, second, most(aside), most(contact => -aside(contact))])];
}
