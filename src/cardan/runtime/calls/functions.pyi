"""Written from the table of functions: pytest tests/golden/test_functions.py --accept"""

from abc import ABCMeta
from typing import Any

from numpy.typing import ArrayLike

from ...arrays import Array
from .evaluation import Evaluation, State, Values
from .methods import Axes, Energy

class Functions(Evaluation, metaclass=ABCMeta):
    def rhs(
        self,
        t: ArrayLike,
        x: ArrayLike,
        r: State | None = None,
        *,
        s: State | None = None,
        tau: State | None = None,
        wrenches: Values | None = None,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Time derivative of the state [q, u, z].

        As SciPy's solvers want it.

        Args:
            t: time [s], (...)
            x: state [q, u] and internal states, (..., nx)
            r: inputs, (..., nr); by default those of the model
            s: modes of elements, (..., ns); by default those at the start
            tau: generalized applied forces, (..., nu); by default none
            wrenches: frame -> (..., 6) at its origin: moment, force; ground axes
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nx) [of the state per s]
        """

    def forward_dynamics(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        wrenches: Values | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """udot with M udot + h = f + tau.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            tau: generalized applied forces, (..., nu); by default none
            wrenches: frame -> (..., 6) at its origin: moment, force; ground axes
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [rad/s^2 or m/s^2]
        """

    def inverse_dynamics(
        self,
        q: State,
        u: State,
        udot: State,
        *,
        wrenches: Values | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """tau with M udot + h = f + tau.

        f are the forces of the model; wrenches act too, so that tau is what is left to do.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            udot: derivatives of the speeds, (..., nu)
            wrenches: frame -> (..., 6) at its origin: moment, force; ground axes
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [N m or N]
        """

    def mass_matrix(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """M: kinetic energy is 1/2 uᵀ M u.

        Of what prescribed motions add to the energy nothing is in it.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu, nu) [kg m^2, kg m or kg]
        """

    def bias(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """h: velocity products and gravity.

        As in Pinocchio and MuJoCo.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [N m or N]
        """

    def gravity(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Part of h that is left at rest.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [N m or N]
        """

    def coriolis(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """h without gravity.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [N m or N]
        """

    def applied_forces(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """f: generalized forces of the model's elements.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [N m or N]
        """

    def qdot(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """qdot = N(q) u + n(t, q).

        Rates of the coordinates.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nq) [rad/s, 1/s or m/s]
        """

    def energy(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
    ) -> Energy:
        """Kinetic, potential and total energy.

        The potential of gravity is 0 at the ground origin.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model

        Returns:
            Energy, (...) each [J]
        """

    def pose(
        self,
        frame: str,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Transform from frame axes to ground axes.

        A homogeneous transform [R, p; 0, 1].

        Args:
            frame: name of a frame
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 4, 4) [1 and m]
        """

    def velocity(
        self,
        frame: str,
        q: State,
        u: State,
        *,
        in_: Axes = "ground",
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Angular velocity and velocity of the origin, ground axes.

        Args:
            frame: name of a frame
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            in_: axes of the result, ``"ground"`` or ``"frame"``
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 6) [rad/s and m/s]
        """

    def acceleration(
        self,
        frame: str,
        q: State,
        u: State,
        udot: State,
        *,
        in_: Axes = "ground",
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Angular acceleration and acceleration of the origin, ground axes.

        Gravity is not in it: a body at rest has 0.

        Args:
            frame: name of a frame
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            udot: derivatives of the speeds, (..., nu)
            in_: axes of the result, ``"ground"`` or ``"frame"``
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 6) [rad/s^2 and m/s^2]
        """

    def frame_jacobian(
        self,
        frame: str,
        q: State,
        *,
        in_: Axes = "ground",
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Velocity = J u, ground axes.

        Rows are [omega, v] of the frame origin. Where joints are prescribed, their part of the
        velocity is not a part of J u.

        Args:
            frame: name of a frame
            q: coordinates, (..., nq)
            in_: axes of the result, ``"ground"`` or ``"frame"``
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 6, nu) [1, m or 1/m]
        """

    def com(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Center of mass in ground axes.

        Of everything that moves.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 3) [m]
        """

    def momentum(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Angular (about the ground origin) and linear momentum.

        In ground axes.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 6) [kg m^2/s and kg m/s]
        """

    def momenta(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """p = dT/du: momenta along the speeds.

        They are canonical where speeds are rates of coordinates.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [kg m^2/s or kg m/s]
        """

    def momentum_rates(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Rates of the momenta under forces and constraints.

        Of ``momenta``, under tau, the forces of the model and its constraints.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            tau: generalized applied forces, (..., nu); by default none
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu) [N m or N]
        """

    def hamiltonian(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """H = p . u - T + V.

        The energy, where no motion is prescribed.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (...) [J]
        """

    def reaction(
        self,
        joint: str,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        wrenches: Values | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Wrench of parent on child at the child joint frame, in its axes.

        [Mx, My, Mz, Fx, Fy, Fz]. The system accelerates under tau and wrenches. Where redundant
        constraints leave reactions undetermined those of least norm come out: the smallest sum over
        the joints of squares of forces, and of moments over the largest distance between two of
        them. A SolveWarning says so once; see ``model.redundancy(q)``. Forces along the joint,
        such as JointSpring, and its tau act through it: Mz of a hinge about z holds them.

        Args:
            joint: name of a joint, with motion, cut or fixed
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            tau: generalized applied forces, (..., nu); by default none
            wrenches: frame -> (..., 6) at its origin: moment, force; ground axes
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 6) [N m and N]
        """

    def outputs(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Declared outputs, then ``<joint>.driving_force`` of prescribed joints.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., ny) [as declared]
        """

    def expression(
        self,
        formula: str,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Value of a formula in names of the model.

        Of coordinates, speeds, internal states, inputs, parameters, outputs and t, as formulas in
        scene files are: ``"(hand.x - 0.4)^2 + 1e-3*tau^2"``.

        Args:
            formula: such as ``"x^2 + 0.1*hand.z"``
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (...) [as its entries have it]
        """

    def element_forces(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Forces of elements by name: along a line or a joint, or on a frame.

        In the order of ``manifest.element_forces``. Along a line a positive force pulls the ends
        together; along a joint it pushes the child in the positive direction; on a frame it is
        [force, moment] at its origin in ground axes. Stops, latches and sticking friction hold
        under the forces of the model and tau; impulses of impacts are not in it.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            tau: generalized applied forces, (..., nu); by default none
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nforces) [N or N m]
        """

    def power(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Power of everything that has no potential, by source.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nsources) [W]
        """

    def dependents(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Coordinates, then speeds, of joints that loops determine.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., ndependent) [of the coordinates and speeds]
        """

    def constraints(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """g: what vanishes at position level.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., npositions) [m or rad]
        """

    def constraint_rates(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """G u + g_t: what vanishes at velocity level.

        The derivative of g first.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nlam) [m/s or rad/s]
        """

    def constraint_jacobian(
        self,
        q: State,
        *,
        r: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """G: G udot = gamma.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nlam, nu) [1, m or 1/m]
        """

    def closure(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Closing conditions of all cut joints, dependent ones too.

        Also those that follow from others.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nclosing) [m or 1]
        """

    def assembly_signs(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Cosines, all positive where no cut joint is turned round.

        Closing conditions vanish too where an axis is turned round; then one of these does not
        exceed 0. They are named in the manifest after their joints.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., ncosines) [1]
        """

    def multipliers(
        self,
        q: State,
        u: State,
        *,
        tau: State | None = None,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """lam: forces of constraint, M udot + h = f + tau + Gᵀ lam.

        0 for rows that follow from others. q and u are on the constraints.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            tau: generalized applied forces, (..., nu); by default none
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nlam) [N or N m]
        """

    def close_position(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """q moved onto the constraints by one step, and g before it.

        The step is the shortest in the metric of M; repeated, it converges quadratically.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nq+npositions) [of q, then of g]
        """

    def close_velocity(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """U moved onto the constraints, and their rates before.

        M is the metric.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu+nlam) [of u, then of the rates]
        """

    def events(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Numbers that fall through zero where an event happens.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., ne) [of each event]
        """

    def transition(
        self,
        q: State,
        u: State,
        events: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Speeds, internal and discrete states behind the events e.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            events: 1 for every event that happens, else 0, (..., ne)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu+nz+ns) [of u, z and s]
        """

    def strain_energy(
        self,
        q: State,
        *,
        r: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Energy of springs, bushings and cables, without loads.

        Of all elements whose potential is the energy of a strain, at the present time and inputs.

        Args:
            q: coordinates, (..., nq)
            r: inputs, (..., nr); by default those of the model
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (...) [J]
        """

    def regressor(
        self,
        q: State,
        u: State,
        udot: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Y: tau is Y phi and what does not depend on phi, the inertial parameters.

        The numbers phi are named by ``inertial_parameters``: ten of every body, then
        coefficients of force elements. Nothing else is left over in a robot whose forces are
        gravity, damping and friction.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            udot: derivatives of the speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., nu, nphi) [of tau per phi]

        Source: Atkeson, An and Hollerbach, Int. J. Robotics Research 5 (1986).
        """

    def energy_regressor(
        self,
        q: State,
        u: State,
        *,
        r: State | None = None,
        z: State | None = None,
        s: State | None = None,
        t: ArrayLike = 0.0,
        parameters: Values | None = None,
        out: Array | None = None,
    ) -> Array:
        """Kinetic and potential energy, and power without a potential, per inertial parameter.

        The power is that of coefficients without a potential, such as damping, negative where
        they take energy. What the energies gain is what tau and powers give: no accelerations
        are needed. Not for systems that time or inputs move.

        Args:
            q: coordinates, (..., nq)
            u: speeds, (..., nu)
            r: inputs, (..., nr); by default those of the model
            z: internal states of elements, (..., nz); by default those at the start
            s: modes of elements, (..., ns); by default those at the start
            t: time [s], (...)
            parameters: name -> value (...); by default those of the model
            out: array that is filled and returned

        Returns:
            (..., 3, nphi) [J, J, W per phi]

        Source: Gautier and Khalil, IEEE Conf. Decision and Control (1988).
        """

    def inertial_parameters(
        self,
        parameters: Values | None = None,
    ) -> dict[str, Any]:
        """phi: what forces and energies are linear in.

        By name: ``<body>.mass``, ``.moment_x`` ..., ``.xx`` ... ``.yz``: mass, first moments
        and inertia about the frame of the body, in its axes, of the body with everything fixed
        to it; then ``<element>.damping`` and the like.

        Args:
            parameters: name -> value (...); by default those of the model

        Returns:
            dict[str, Any], (...) each [kg, kg m, kg m^2 and as declared]
        """

    def integrate(
        self,
        q: State,
        du: State,
        *,
        out: Array | None = None,
    ) -> Array:
        """q moved by a finite increment du along the speeds.

        Args:
            q: coordinates, (..., nq)
            du: finite increment along the speeds, (..., nu)
            out: array that is filled and returned

        Returns:
            (..., nq) [of q]
        """

    def difference(
        self,
        q0: State,
        q1: State,
        *,
        out: Array | None = None,
    ) -> Array:
        """du that moves q0 to q1.

        ``integrate(q0, du)`` is q1.

        Args:
            q0: coordinates at the start of the increment, (..., nq)
            q1: coordinates, (..., nq)
            out: array that is filled and returned

        Returns:
            (..., nu) [rad or m]
        """

    def rhs_jacobian(
        self,
        t: ArrayLike,
        x: ArrayLike,
        r: State | None = None,
        *,
        s: State | None = None,
        parameters: Values | None = None,
    ) -> tuple[Array, Array, Array]:
        """d rhs / d x, / d t and / d r, x as it is stored.

        A unit quaternion counts by its direction alone: along itself nothing changes.
        Derivatives along the speeds instead: ``derivative("rhs", wrt="q")``. Three arrays:
        (..., nx, nx), (..., nx) and (..., nx, nr).

        Args:
            t: time [s], (...)
            x: state [q, u] and internal states, (..., nx)
            r: inputs, (..., nr); by default those of the model
            s: modes of elements, (..., ns); by default those at the start
            parameters: name -> value (...); by default those of the model

        Returns:
            tuple[Array, Array, Array], (...) each [of rhs per x, s and r]
        """
