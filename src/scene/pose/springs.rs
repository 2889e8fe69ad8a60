//! Springs at points of joined bodies, and forces on such points, as far as geometry tells: between which places they lie.
use crate::num::jet::Followed;
use crate::num::{Real, root};
use crate::scene::pose::{
    Layout, Poses, direction, dot, fixed, foot, from_origin, ground, less, turned_from,
};
use crate::scene::{Acts, Num, Rest, Spot, Strut, StrutEnd};
use smallvec::SmallVec;

impl<T: Real> Layout<'_, T> {
    /// Notes how long the springs are where nothing stretches them, and where torsion springs are relaxed; `None` if the joints do not
    /// place the bodies at the start.
    pub fn measure_springs(&mut self) -> Option<()> {
        if self.scene.struts.is_empty() {
            return Some(());
        }
        let start = self.poses::<T>(T::zero(), true)?;
        for (s, strut) in self.scene.struts.iter().enumerate() {
            self.relaxed_axes.push(self.relaxed(strut)?);
            self.natural.push(match strut.rest {
                _ if strut.twists() => T::zero(),
                Rest::Length(l) => self.n.get(l),
                Rest::Stretch(x) => self.length(&start, s) - self.n.get(x),
            });
        }
        Some(())
    }
    /// From one end of a spring to the other; of a torsion spring the angle of its body from where that is relaxed.
    pub fn span<X: Followed<T>>(&self, poses: &Poses<X>, strut: usize) -> [X; 2] {
        let Strut { at, to, .. } = &self.scene.struts[strut];
        let near = self.spot(*at, poses);
        let far = match *to {
            StrutEnd::Ground(place) => fixed(ground(self.n, place)),
            StrutEnd::Spot(spot) => self.spot(spot, poses),
            StrutEnd::Guide { through_m, direction_deg } => {
                foot(near, fixed(ground(self.n, through_m)), fixed(direction(self.n, direction_deg)))
            }
            StrutEnd::Twist => {
                let Some(planar) = self.scene.planar(at.body) else { return [X::still(T::zero()); 2] };
                let [c, s] = poses[at.body].axis;
                let turned = turned_from(planar, [c.here(), s.here()], self.relaxed_axes[strut]);
                let angle = X::with(turned, || {
                    let (by_c, by_s) = (c.derivatives(), s.derivatives());
                    [0, 1].map(|i| (c.here() * by_s[i] - s.here() * by_c[i]).signed(planar.sense()))
                });
                return [angle, X::still(T::zero())];
            }
        };
        less(far, near)
    }
    /// Length of a spring; of a torsion spring that angle.
    pub fn length<X: Followed<T>>(&self, poses: &Poses<X>, strut: usize) -> X {
        let apart = self.span(poses, strut);
        if self.scene.struts[strut].twists() { apart[0] } else { dot(apart, apart).square_root() }
    }
    /// How far it is longer than it naturally is, or turned beyond where it is relaxed, whether or not it acts there.
    pub fn beyond<X: Followed<T>>(&self, poses: &Poses<X>, strut: usize) -> T {
        self.length(poses, strut).here().balance(-self.natural[strut])
    }
    /// Does a spring press or pull that is so much longer than it naturally is, if it can do but one of them?
    pub fn acts(&self, strut: usize, beyond: T) -> bool {
        match self.scene.struts[strut].acts {
            Acts::Both => true,
            Acts::Pushes => beyond.sign() <= 0.0,
            Acts::Pulls => beyond.sign() >= 0.0,
        }
    }
    /// After which ways in this sense, looked for up to `far`, springs that only push or pull are met or let go of, one after the other;
    /// of `all` springs also those after which one is shortest or longest, between two of which it is met once at most, however
    /// short it is.
    pub fn meets(&self, all: bool, sense: f64, far: (T, T)) -> SmallVec<[(usize, T); 4]> {
        let struts = self.scene.struts.iter().enumerate();
        let looked = struts.filter(|(_, s)| s.acts != Acts::Both || all && !s.twists());
        let ways = looked.flat_map(|(s, strut)| {
            let poses = |way: T| self.poses::<T>(way.signed(sense), false).ok_or(());
            let square = |way: T| {
                let apart = self.span(&poses(way)?, s);
                Ok::<_, ()>(dot(apart, apart))
            };
            let turns = if strut.twists() { SmallVec::new() } else { root::turns(far, &square) };
            let value = |way: T| Ok::<_, ()>(self.beyond(&poses(way)?, s));
            let met = root::changes(far, &turns, &value).unwrap_or_default();
            met.into_iter().chain(turns.into_iter().filter(move |_| all)).map(move |way| (s, way))
        });
        let mut ways: SmallVec<[(usize, T); 4]> = ways.collect();
        ways.sort_by(|a, b| a.1.f64().total_cmp(&b.1.f64()));
        ways
    }
    /// How far a point is from a fixed place.
    pub fn distance<X: Followed<T>>(&self, poses: &Poses<X>, at: Spot, place_m: [Num; 2]) -> X {
        let apart = less(self.spot(at, poses), fixed(ground(self.n, place_m)));
        dot(apart, apart).square_root()
    }
    /// The direction from a point to a fixed place, and how far that is.
    pub fn toward<X: Followed<T>>(&self, poses: &Poses<X>, at: Spot, place_m: [Num; 2]) -> ([X; 2], X) {
        let apart = less(fixed(ground(self.n, place_m)), self.spot(at, poses));
        let length = dot(apart, apart).square_root();
        (apart.map(|x| x / length), length)
    }
    /// Direction of a force on a point.
    pub fn push<X: Followed<T>>(&self, poses: &Poses<X>, push: usize) -> [T; 2] {
        let (given, own) = (&self.scene.pushes[push], self.pushes[push]);
        if let Some(place) = given.toward_m {
            return self.toward(poses, given.at, place).0.map(X::here);
        }
        if given.turns { from_origin(poses[given.at.body].axis.map(X::here), own) } else { own }
    }
}
